// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "fast_dds/raw_ends.hpp"
#include "graph/ros_graph.hpp"

namespace tocsin {

/// Tells ROS 2 the nodes of this process. A process without nodes has no end of this. One thread.
class GraphWriter {
 public:
  /// `size`: of gids; empty: as the peers understand them.
  GraphWriter(FastDdsParticipant& participant, std::optional<GidSize> size)
      : participant_(participant), size_(size) {}
  /// Sends a sample when it differs from the last one, or the peers now take another size.
  void tell(const std::vector<GraphNode>& nodes);
  /// The same, as cheap as a look when nothing has changed since.
  void follow(const LocalNodes& nodes);

 private:
  FastDdsParticipant& participant_;
  const std::optional<GidSize> size_;
  std::vector<std::uint8_t> last_;
  std::uint64_t followed_ = 0;
  std::unique_ptr<RawWriter> writer_;
};

/// What ends of ros_discovery_info ask for or offer: reliable, transient local, `depth`.
[[nodiscard]] QosProfile discovery_qos(int depth);

}  // namespace tocsin
