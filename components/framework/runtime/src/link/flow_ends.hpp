// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <functional>
#include <optional>
#include <string>

#include "fast_dds/cdr_topic_type.hpp"
#include "fast_dds/fast_dds_participant.hpp"
#include "fast_dds/node_ends.hpp"
#include "fast_dds/single_drainer.hpp"
#include "graph/ros_graph.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// What all flows of one topic share that one reader can hear.
struct ReaderKey {
  std::string topic;  ///< DDS name
  std::string type;
  bool reliable = false;
  bool transient_local = false;
};
[[nodiscard]] bool operator<(const ReaderKey& one, const ReaderKey& other);

/// One sample as a reader of any type takes it.
struct TakenSample {
  eprosima::fastdds::rtps::GUID_t writer;
  std::uint64_t number = 0;  ///< of its DDS writer
  CarriedSample sample;      ///< of its origin, where the writer tells one
  SamplePiece piece{};       ///< its content is of this
  Duration waited{0};        ///< in a socket of this process, see SocketWait
};

/// Reads a topic of any type. `on_sample` is called by threads of Fast DDS, one at a time.
class FlowReader : private eprosima::fastdds::dds::DataReaderListener {
 public:
  using OnSample = std::function<void(TakenSample&&)>;
  /// Throws EnvironmentError when Fast DDS cannot make it.
  FlowReader(FastDdsParticipant& participant, const ReaderKey& key, OnSample on_sample);
  ~FlowReader() override;
  /// Is an end of this node as long as it lives.
  void belong(LocalNodes& nodes, const std::string& node);

 private:
  using Reader = eprosima::fastdds::dds::DataReader;
  void on_data_available(Reader* reader) override;
  void drain(Reader* reader);

  FastDdsParticipant& participant_;
  const TypeInfo& type_;
  OnSample on_sample_;
  SingleDrainer drainer_;
  Reader* reader_;
  std::optional<NodeEnd> node_end_;
};

/// Writes a topic of any type on behalf of others. `on_reader` is called by threads of Fast DDS
/// with the participant of each reader that is matched, and of each that is not any more (false).
class FlowWriter : private eprosima::fastdds::dds::DataWriterListener {
 public:
  using OnReader = std::function<void(const eprosima::fastdds::rtps::GuidPrefix_t&, bool there)>;
  /// Throws EnvironmentError when Fast DDS cannot make it.
  FlowWriter(FastDdsParticipant& participant, const std::string& topic, const std::string& type,
             const QosProfile& qos, OnReader on_reader);
  ~FlowWriter() override;
  /// As FlowReader::belong.
  void belong(LocalNodes& nodes, const std::string& node);

  /// The number that Fast DDS gave it; nothing when it refused. A piece needs encoded content.
  [[nodiscard]] std::optional<std::uint64_t> write(const CarriedSample& sample,
                                                   SamplePiece piece = {});
  /// Without origin and time of sending: of nobody's but the router's own.
  [[nodiscard]] std::optional<std::uint64_t> write_own(const CarriedSample& sample);
  [[nodiscard]] eprosima::fastdds::rtps::EntityId_t entity() const;

 private:
  using Writer = eprosima::fastdds::dds::DataWriter;
  void on_publication_matched(
      Writer* writer, const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;

  FastDdsParticipant& participant_;
  OnReader on_reader_;
  Writer* writer_;
  std::optional<NodeEnd> node_end_;
};

}  // namespace tocsin
