// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "fast_dds/endpoint_account.hpp"
#include "fast_dds/fast_dds_participant.hpp"
#include "fast_dds/single_drainer.hpp"
#include "graph/ros_graph.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/replay_filter.hpp"
#include "runtime/middleware/topic_exchange.hpp"

namespace tocsin {

struct IncomingSample;

/// A DataReader that puts what it takes into an exchange. The listener only queues, it never
/// writes: Fast DDS deadlocks when a callback writes. What this process wrote itself is skipped,
/// because the exchange has delivered it already; with exclusive ownership, where Fast DDS must
/// choose among the writers, everything comes this way.
class DdsReader : private eprosima::fastdds::dds::DataReaderListener {
 public:
  DdsReader(FastDdsParticipant& participant, const std::string& topic, const TypeInfo& type,
            const QosProfile& qos, TopicExchange& exchange);
  /// What the writers wrote that it was matched with is not kept for late receivers any more.
  ~DdsReader() override;
  [[nodiscard]] EndpointHealth health() const;
  /// Requests what of `qos` can change. False when Fast DDS refused it. Not beside health().
  [[nodiscard]] bool change(const QosProfile& qos);
  [[nodiscard]] Gid gid() const;
  /// Empty when it is not matched with that writer.
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const;

 private:
  using Reader = eprosima::fastdds::dds::DataReader;
  void on_data_available(Reader* reader) override;
  void drain(Reader* reader);
  void hand_over_end(const eprosima::fastdds::dds::SampleInfo& info);
  void hand_over(IncomingSample& incoming, const eprosima::fastdds::dds::SampleInfo& info);
  void on_subscription_matched(
      Reader* reader, const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override;
  /// Ends the instances of a writer that is gone, and of those for whom it wrote.
  void forget(const RemoteEnds::Guid& writer);
  void on_requested_incompatible_qos(
      Reader* reader,
      const eprosima::fastdds::dds::RequestedIncompatibleQosStatus& status) override;
  void on_sample_lost(Reader* reader,
                      const eprosima::fastdds::dds::SampleLostStatus& status) override;
  void on_sample_rejected(Reader* reader,
                          const eprosima::fastdds::dds::SampleRejectedStatus& status) override;
  void on_liveliness_changed(
      Reader* reader, const eprosima::fastdds::dds::LivelinessChangedStatus& status) override;
  [[nodiscard]] bool next_is_own(Reader* reader) const;
  [[nodiscard]] bool has_other_layout(const RemoteEnds::Guid& writer);
  [[nodiscard]] bool has_outlived_its_lifespan(const RemoteEnds::Guid& writer) const;
  /// False for a sample that a router has carried here once already. Its writer is known by the
  /// router's from then on.
  [[nodiscard]] bool is_first(const eprosima::fastdds::dds::SampleInfo& info);

  FastDdsParticipant& participant_;
  TopicExchange& exchange_;
  const bool skips_own_;
  AnnouncedEnd own_;
  EndpointAccount account_;
  std::atomic<bool> own_matched_{false};
  SingleDrainer drainer_;
  RemoteEnds::Guid last_writer_;  // touched by the one that drains
  bool last_has_other_layout_ = false;
  mutable std::mutex sources_mutex_;
  /// The writers that it is matched with, and those for whom one of these writes.
  std::map<std::uint64_t, RemoteEnds::Guid> sources_;
  ReplayFilter carried_;
  Reader* reader_;
};

/// A DataWriter that knows how many readers it has outside this process.
class DdsWriter : private eprosima::fastdds::dds::DataWriterListener {
 public:
  DdsWriter(FastDdsParticipant& participant, const std::string& topic, const TypeInfo& type,
            const QosProfile& qos);
  ~DdsWriter();

  /// False when the middleware refused it.
  [[nodiscard]] bool send(const void* message);
  /// Ends the instance of a message's key. False: it was never written, or has no key.
  [[nodiscard]] bool end_instance(const void* message, InstanceState how);
  /// Readers in other processes.
  [[nodiscard]] int matched_readers() const { return matched_.load(std::memory_order_relaxed); }
  [[nodiscard]] EndpointHealth health() const;
  /// Offers what of `qos` can change. False when Fast DDS refused it. Not beside health().
  [[nodiscard]] bool change(const QosProfile& qos);
  [[nodiscard]] Gid gid() const;

 private:
  using Writer = eprosima::fastdds::dds::DataWriter;
  void on_publication_matched(
      Writer* writer, const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;
  void on_offered_incompatible_qos(
      Writer* writer, const eprosima::fastdds::dds::OfferedIncompatibleQosStatus& status) override;
  void on_liveliness_lost(Writer* writer,
                          const eprosima::fastdds::dds::LivelinessLostStatus& status) override;
  FastDdsParticipant& participant_;
  AnnouncedEnd own_;
  EndpointAccount account_;
  std::atomic<int> matched_{0};
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<std::uint64_t> refused_{0};
  Writer* writer_;
};

}  // namespace tocsin
