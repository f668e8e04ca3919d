// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/graph_writer.hpp"
#include "graph/ros_graph.hpp"
#include "runtime/fast_dds/names.hpp"

#include <utility>

namespace tocsin {

QosProfile discovery_qos(int depth) {
  QosProfile qos;
  qos.reliability = Reliability::reliable;
  qos.durability = Durability::transient_local;
  qos.depth = depth;
  qos.user_data = discovery_user_data();
  return qos;
}

void GraphWriter::tell(const std::vector<GraphNode>& nodes) {
  if (nodes.empty() && !writer_) return;
  const GidSize size =
      size_.value_or(gid_size_for(participant_.remote_ends().user_data_of(discovery_topic)));
  auto bytes = encode(ParticipantNodes{gid_of(participant_.guid()), nodes}, size);
  if (bytes == last_) return;
  if (!writer_) {
    writer_ = std::make_unique<RawWriter>(
        participant_, RawEnd{discovery_topic, discovery_type, discovery_qos(1)});
  }
  eprosima::fastdds::rtps::WriteParams params;
  if (writer_->write(bytes, params)) last_ = std::move(bytes);
}

void GraphWriter::follow(const LocalNodes& nodes) {
  const std::uint64_t changes = nodes.changes();
  if (std::exchange(followed_, changes) != changes) tell(nodes.all());
}

}  // namespace tocsin
