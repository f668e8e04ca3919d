// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <string>

#include "fast_dds_participant.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/gated_writer.hpp"
#include "runtime/middleware/topic_exchange.hpp"

namespace tocsin {

/// A DataReader that puts what it takes into an exchange. The listener only queues, it never
/// writes: Fast DDS deadlocks when a callback writes. What this process wrote itself is skipped:
/// the exchange has delivered it already.
class DdsReader : private eprosima::fastdds::dds::DataReaderListener {
 public:
  DdsReader(FastDdsParticipant& participant, const std::string& topic, const TypeInfo& type,
            const QosProfile& qos, TopicExchange& exchange);
  ~DdsReader() override;

 private:
  using Reader = eprosima::fastdds::dds::DataReader;
  void on_data_available(Reader* reader) override;
  void on_requested_incompatible_qos(
      Reader* reader,
      const eprosima::fastdds::dds::RequestedIncompatibleQosStatus& status) override;
  FastDdsParticipant& participant_;
  TopicExchange& exchange_;
  Logger log_;
  Reader* reader_;
};

/// A DataWriter that knows how many readers it has outside this process.
class DdsWriter : public LinkWriter, private eprosima::fastdds::dds::DataWriterListener {
 public:
  DdsWriter(FastDdsParticipant& participant, const std::string& topic, const TypeInfo& type,
            const QosProfile& qos);
  ~DdsWriter() override;

  bool send(const void* message) override;
  void silence() override;
  [[nodiscard]] int matched_readers() const { return matched_; }

 private:
  using Writer = eprosima::fastdds::dds::DataWriter;
  void on_publication_matched(
      Writer* writer, const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;
  void on_offered_incompatible_qos(
      Writer* writer, const eprosima::fastdds::dds::OfferedIncompatibleQosStatus& status) override;
  FastDdsParticipant& participant_;
  Logger log_;
  std::atomic<int> matched_{0};
  Writer* writer_;
};

}  // namespace tocsin
