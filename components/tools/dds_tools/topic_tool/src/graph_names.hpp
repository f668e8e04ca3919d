// SPDX-License-Identifier: Apache-2.0
// What the pages on topics, services and nodes have in common.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::topic_tool {

/// Whether a part of the name begins with _, which is shown to those who ask for it.
[[nodiscard]] inline bool is_hidden(const std::string& name) {
  return name.find("/_") != std::string::npos;
}

/// Types that stand under one name, as a terminal may show them.
[[nodiscard]] inline std::string types_text(const std::set<std::string>& types) {
  return printable(joined(std::vector<std::string>(types.begin(), types.end())));
}

/// Whether the node has this end.
[[nodiscard]] inline bool has_end(const GraphNode& node, const GraphEnd& end) {
  const auto& own = end.writer ? node.writers : node.readers;
  return std::find(own.begin(), own.end(), end.gid) != own.end();
}

}  // namespace tocsin::topic_tool
