// SPDX-License-Identifier: Apache-2.0
#include <dds/dds.h>

#include <array>
#include <stdexcept>

#include "peer.hpp"
#include "std_msgs.h"

namespace tocsin::interop {
namespace {

dds_entity_t checked(dds_entity_t entity) {
  if (entity < 0) throw std::runtime_error(std::string("Cyclone DDS: ") + dds_strretcode(-entity));
  return entity;
}

class CyclonePeer : public Peer {
 public:
  explicit CyclonePeer(const PeerSettings& settings)
      : participant_(checked(dds_create_participant(static_cast<dds_domainid_t>(settings.domain),
                                                    nullptr, nullptr))) {
    dds_topic_descriptor_t type = std_msgs_msg_String_desc;
    type.m_typename = type_on_wire;
    const dds_entity_t topic =
        checked(dds_create_topic(participant_, &type, topic_on_wire, nullptr, nullptr));
    dds_qos_t* const qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 1000);
    reader_ = checked(dds_create_reader(participant_, topic, qos, nullptr));
    if (settings.lifespan_ms > 0) dds_qset_lifespan(qos, DDS_MSECS(settings.lifespan_ms));
    writer_ = checked(dds_create_writer(participant_, topic, qos, nullptr));
    dds_delete_qos(qos);
  }
  ~CyclonePeer() override { (void)dds_delete(participant_); }

  void write(const std::string& text) override {
    std_msgs_msg_String message{const_cast<char*>(text.c_str())};
    (void)dds_write(writer_, &message);
  }

  std::vector<HeardText> take() override {
    std::vector<HeardText> texts;
    std::array<void*, 64> samples{};
    std::array<dds_sample_info_t, 64> infos{};
    for (;;) {
      const dds_return_t count =
          dds_take(reader_, samples.data(), infos.data(), samples.size(), samples.size());
      if (count <= 0) return texts;
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (infos[i].valid_data) {
          texts.push_back({static_cast<const std_msgs_msg_String*>(samples[i])->data, now_ms()});
        }
      }
      (void)dds_return_loan(reader_, samples.data(), count);
    }
  }

 private:
  dds_entity_t participant_;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
};

}  // namespace

std::unique_ptr<Peer> make_cyclone_peer(const PeerSettings& settings) {
  return std::make_unique<CyclonePeer>(settings);
}

}  // namespace tocsin::interop
