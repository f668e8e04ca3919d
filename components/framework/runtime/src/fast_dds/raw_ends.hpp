// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fast_dds/fast_dds_participant.hpp"
#include "fast_dds/single_drainer.hpp"
#include "graph/ros_graph.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// A GUID as ROS 2 sends it.
[[nodiscard]] Gid gid_of(const eprosima::fastdds::rtps::GUID_t& guid);

/// An end as it stands on the wire.
struct RawEnd {
  std::string topic;
  std::string type;
  QosProfile qos;
};

/// An end at the other side came or went. Called by threads of Fast DDS; must not call it.
using OnMatch = std::function<void(const eprosima::fastdds::rtps::GUID_t& other, bool there)>;

/// Reads encoded messages of any type, its own process's too. The callbacks are called by threads
/// of Fast DDS and must not write.
class RawReader : private eprosima::fastdds::dds::DataReaderListener {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using OnSample = std::function<void(const std::shared_ptr<const Bytes>& bytes,
                                      const eprosima::fastdds::dds::SampleInfo& info)>;
  /// Throws EnvironmentError when Fast DDS refuses.
  RawReader(FastDdsParticipant& participant, RawEnd end, OnSample on_sample, OnMatch on_match = {});
  ~RawReader() override;
  [[nodiscard]] Gid gid() const;

 private:
  using Reader = eprosima::fastdds::dds::DataReader;
  void on_data_available(Reader* reader) override;
  void drain(Reader* reader);
  void on_subscription_matched(
      Reader* reader, const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override;

  FastDdsParticipant& participant_;
  const RawEnd end_;  // its profile must outlive the reader
  const OnSample on_sample_;
  const OnMatch on_match_;
  SingleDrainer drainer_;
  Reader* reader_;
};

/// Writes encoded messages of any type.
class RawWriter : private eprosima::fastdds::dds::DataWriterListener {
 public:
  /// See RawReader.
  RawWriter(FastDdsParticipant& participant, RawEnd end, OnMatch on_match = {});
  ~RawWriter() override;
  /// `bytes` begin with their encapsulation header. False when the middleware refused it; `params`
  /// tell its number then.
  [[nodiscard]] bool write(std::vector<std::uint8_t> bytes,
                           eprosima::fastdds::rtps::WriteParams& params);
  [[nodiscard]] Gid gid() const;

 private:
  using Writer = eprosima::fastdds::dds::DataWriter;
  void on_publication_matched(
      Writer* writer, const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;

  FastDdsParticipant& participant_;
  const RawEnd end_;
  const OnMatch on_match_;
  Writer* writer_;
};

}  // namespace tocsin
