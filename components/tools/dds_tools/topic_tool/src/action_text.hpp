// SPDX-License-Identifier: Apache-2.0
// What `ros2 action` prints, from who is on a host's domain.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

/// Who has an action: paths of nodes, with the types under which each has it.
struct ActionEnds {
  std::set<std::string> types;
  std::map<std::string, std::set<std::string>> servers;
  std::map<std::string, std::set<std::string>> clients;
};

/// By name. An end of a process that names no node counts for the action, and as nobody.
[[nodiscard]] std::map<std::string, ActionEnds> actions_in(const std::vector<GraphEnd>& ends,
                                                           const std::vector<GraphNode>& nodes);

struct ActionListOptions {
  bool types = false;  ///< -t: each with its types
  bool count = false;  ///< -c: how many there are
};

/// Actions by name; a line each.
[[nodiscard]] std::string action_list_text(const std::map<std::string, ActionEnds>& actions,
                                           const ActionListOptions& options);
[[nodiscard]] std::string action_info_text(const std::string& name, const ActionEnds& ends,
                                           const ActionListOptions& options);

}  // namespace tocsin::topic_tool
