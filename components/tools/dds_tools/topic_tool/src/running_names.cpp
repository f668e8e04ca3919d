// SPDX-License-Identifier: Apache-2.0
#include "running_names.hpp"

#include <algorithm>
#include <set>

#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::topic_tool {
namespace {

bool is_like(const std::string& name, const std::string& given) {
  if (!similar({name}, given).empty()) return true;
  const auto words = words_of_path(name);
  const auto asked = words_of_path(given);
  return asked.size() == 1 && !words.empty() && !similar({words.back()}, asked[0]).empty();
}

}  // namespace

std::string suggested_names(const std::vector<std::string>& names, const std::string& given) {
  std::set<std::string> near;
  for (const std::string& name : names) {
    if (name != given && is_like(name, given)) near.insert("'" + printable(name) + "'");
  }
  const std::vector<std::string> all(near.begin(), near.end());
  return all.empty() ? "" : "; did you mean " + joined(all, " or ") + "?";
}

std::vector<std::string> node_paths(const HostGraph& graph) {
  std::vector<std::string> paths;
  for (const GraphNode& node : graph.nodes()) paths.push_back(node.path());
  return paths;
}

}  // namespace tocsin::topic_tool
