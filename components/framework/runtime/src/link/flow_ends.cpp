// SPDX-License-Identifier: Apache-2.0
#include "link/flow_ends.hpp"

#include <tuple>
#include <utility>

#include "graph/ros_graph.hpp"
#include "link/encoded_piece.hpp"
#include "rtps/origin.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "transport/socket_wait.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

/// Samples of a burst that wait until a thread of Fast DDS has handed them on. What is repaired
/// comes in larger ones: all that waited behind a lost sample, or a writer's whole history.
constexpr int reader_depth = 32;
constexpr int reliable_reader_depth = 1000;

QosProfile profile_of(const ReaderKey& key) {
  QosProfile profile;
  profile.reliability = key.reliable ? Reliability::reliable : Reliability::best_effort;
  profile.durability =
      key.transient_local ? Durability::transient_local : Durability::volatile_kind;
  profile.depth = key.reliable ? reliable_reader_depth : reader_depth;
  return profile;
}

TakenSample taken(IncomingSample& incoming, const dds::SampleInfo& info) {
  TakenSample result;
  result.writer = info.sample_identity.writer_guid();
  result.number = info.sample_identity.sequence_number().to64long();
  const auto origin = origin_in(info.related_sample_identity);
  result.sample.content = std::move(incoming.message);
  result.sample.bytes = incoming.bytes;
  result.sample.source = origin ? origin->source : source_of(result.writer);
  result.sample.sequence = origin ? origin->sequence : result.number;
  if (origin) {
    result.piece = origin->piece;
    result.sample.coding = origin->coding;
  }
  result.sample.sent_wall_ns = info.source_timestamp.to_ns();
  result.waited = waited_in_socket();
  return result;
}

/// The number that Fast DDS gave it; nothing when it refused.
std::optional<std::uint64_t> put(dds::DataWriter& writer, OutgoingSample& outgoing,
                                 rtps::WriteParams& params) {
  auto* const carried = static_cast<CarriedMessage*>(&outgoing);
  if (!fast_dds::is_ok(writer.write(carried, params))) return std::nullopt;
  return params.sample_identity().sequence_number().to64long();
}

}  // namespace

bool operator<(const ReaderKey& one, const ReaderKey& other) {
  const auto all = [](const ReaderKey& key) {
    return std::tie(key.topic, key.type, key.reliable, key.transient_local);
  };
  return all(one) < all(other);
}

FlowReader::FlowReader(FastDdsParticipant& participant, const ReaderKey& key, OnSample on_sample)
    : participant_(participant),
      type_(raw_type(key.type)),
      on_sample_(std::move(on_sample)),
      reader_(participant.create_reader(key.topic, type_, profile_of(key), *this)) {}

FlowReader::~FlowReader() { participant_.remove(reader_); }

void FlowReader::belong(LocalNodes& nodes, const std::string& node) {
  node_end_.emplace(nodes, node, LocalNodes::End::reader, gid_of(reader_->guid()));
}

void FlowReader::on_data_available(Reader* reader) {
  drainer_.run([this, reader] { drain(reader); });
}

void FlowReader::drain(Reader* reader) {
  IncomingSample incoming;
  dds::SampleInfo info;
  while (reader->take_next_sample(static_cast<CarriedMessage*>(&incoming), &info) ==
         dds::RETCODE_OK) {
    if (!info.valid_data || participant_.owns(info.sample_identity.writer_guid())) continue;
    if (incoming.valid) on_sample_(taken(incoming, info));
  }
}

FlowWriter::FlowWriter(FastDdsParticipant& participant, const std::string& topic,
                       const std::string& type, const QosProfile& qos, OnReader on_reader)
    : participant_(participant),
      on_reader_(std::move(on_reader)),
      writer_(participant.create_writer(topic, raw_type(type), qos, *this)) {}

FlowWriter::~FlowWriter() { participant_.remove(writer_); }

void FlowWriter::belong(LocalNodes& nodes, const std::string& node) {
  node_end_.emplace(nodes, node, LocalNodes::End::writer, gid_of(writer_->guid()));
}

std::optional<std::uint64_t> FlowWriter::write(const CarriedSample& sample, SamplePiece piece) {
  EncodedMessage part;
  if (!piece.is_whole()) part = cut_out(content_of(sample), piece);
  OutgoingSample outgoing(piece.is_whole() ? sample.content.get() : &part);
  rtps::WriteParams params =
      on_behalf_of({sample.source, sample.sequence, piece, sample.coding}, sample.sent_wall_ns);
  return put(*writer_, outgoing, params);
}

std::optional<std::uint64_t> FlowWriter::write_own(const CarriedSample& sample) {
  OutgoingSample outgoing(sample.content.get());
  rtps::WriteParams params;
  return put(*writer_, outgoing, params);
}

rtps::EntityId_t FlowWriter::entity() const { return writer_->guid().entityId; }

void FlowWriter::on_publication_matched(Writer*, const dds::PublicationMatchedStatus& status) {
  const auto reader = rtps::iHandle2GUID(status.last_subscription_handle);
  on_reader_(reader.guidPrefix, status.current_count_change > 0);
}

}  // namespace tocsin
