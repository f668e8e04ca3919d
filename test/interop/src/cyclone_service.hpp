// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "cyclone.hpp"
#include "fast_dds_service.hpp"

namespace tocsin::interop {

/// As rmw_cyclonedds has it: headers in the messages.
template <class Read, class Written>
class CycloneService {
 public:
  CycloneService(int domain, const dds_topic_descriptor_t& written, const FastDdsService::Half& to,
                 const dds_topic_descriptor_t& read, const FastDdsService::Half& from)
      : participant_(domain) {
    const auto qos = CycloneParticipant::qos();
    dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 10);
    reader_ = participant_.reader(participant_.topic(read, from.topic, from.type.c_str()), qos);
    writer_ = participant_.writer(participant_.topic(written, to.topic, to.type.c_str()), qos);
  }
  [[nodiscard]] bool is_connected() const {
    dds_publication_matched_status_t readers{};
    dds_subscription_matched_status_t writers{};
    (void)dds_get_publication_matched_status(writer_, &readers);
    (void)dds_get_subscription_matched_status(reader_, &writers);
    return readers.current_count > 0 && writers.current_count > 0;
  }
  void write(const Written& message) { (void)dds_write(writer_, &message); }
  /// Calls `use` with each message.
  template <class Use>
  void take(const Use& use) {
    take_all<Read>(reader_, use);
  }

 private:
  CycloneParticipant participant_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
};

}  // namespace tocsin::interop
