// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "mapping/pose_graph.hpp"

namespace tocsin::bench {

/// A drive through a town of streets 5 m apart, 1 m a node, with noisy wheels, and true loops where
/// it comes by again.
struct TownGraph {
  mapping::PoseGraph graph;
  std::vector<geometry::Pose> truth;
};
[[nodiscard]] TownGraph town_graph(std::size_t nodes, int false_loops);

/// Mean distance of the nodes from the truth [m].
[[nodiscard]] double error_m(const TownGraph& town);

}  // namespace tocsin::bench
