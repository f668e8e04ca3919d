// SPDX-License-Identifier: Apache-2.0
// What `ros2 node list` and `info` print, from who is on a host's domain.
#pragma once

#include <string>
#include <vector>

#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

struct NodeListOptions {
  bool hidden = false;  ///< -a: those whose name begins with _, too
  bool count = false;   ///< -c: how many there are
};

/// A line each, by path; a name that two nodes share is there twice.
[[nodiscard]] std::string node_list_text(const std::vector<GraphNode>& nodes,
                                         const NodeListOptions& options);

/// Whether two nodes have one name, of which ROS 2 warns.
[[nodiscard]] bool has_twins(const std::vector<GraphNode>& nodes);

/// What a node reads, writes, serves and calls. `path`: with or without the slash in front. Empty:
/// there is no such node. `hidden`: names with a part that begins with _, too.
[[nodiscard]] std::string node_info_text(const std::vector<GraphEnd>& ends,
                                         const std::vector<GraphNode>& nodes,
                                         const std::string& path, bool hidden);

}  // namespace tocsin::topic_tool
