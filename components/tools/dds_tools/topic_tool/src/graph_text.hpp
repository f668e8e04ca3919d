// SPDX-License-Identifier: Apache-2.0
// What `ros2 topic list`, `info`, `type` and `find` print, from who is on a host's domain.
#pragma once

#include <string>
#include <vector>

#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

struct ListOptions {
  bool types = false;    ///< -t: each with its types
  bool count = false;    ///< -c: how many there are
  bool verbose = false;  ///< -v: apart, with the number of ends
  bool hidden = false;   ///< --include-hidden-topics: those with a part that begins with _, too
};

/// Topics of ROS, by name; a line each.
[[nodiscard]] std::string list_text(const std::vector<GraphEnd>& ends, const ListOptions& options);

/// Empty: nobody writes or reads it.
[[nodiscard]] std::string info_text(const std::vector<GraphEnd>& ends,
                                    const std::vector<GraphNode>& nodes,
                                    const std::string& ros_topic, bool verbose);

/// ROS types under the name of a topic; several when its ends disagree.
[[nodiscard]] std::vector<std::string> types_of(const std::vector<GraphEnd>& ends,
                                                const std::string& ros_topic);

/// Topics of a ROS type, by name.
[[nodiscard]] std::vector<std::string> topics_of_type(const std::vector<GraphEnd>& ends,
                                                      const std::string& ros_type);

/// How to read a topic so that all its writers are heard: reliable and with the last samples where
/// all offer it. Throws EnvironmentError when nobody has announced a type for it.
[[nodiscard]] RawTopic readable(const std::vector<GraphEnd>& ends, const std::string& ros_topic);

}  // namespace tocsin::topic_tool
