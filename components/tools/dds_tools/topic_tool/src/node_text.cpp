// SPDX-License-Identifier: Apache-2.0
#include "node_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "graph_names.hpp"

namespace tocsin::topic_tool {
namespace {

using TypesByName = std::map<std::string, std::set<std::string>>;

/// A node's names, by what it does with them.
struct Names {
  TypesByName read;
  TypesByName written;
  TypesByName served;
  TypesByName called;
  TypesByName actions_served;
  TypesByName actions_called;
};

const std::string goal_service = "/_action/send_goal";

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// The action that is behind `/name/_action/send_goal`, with `pkg/action/Name`.
void add_action(TypesByName& actions, const std::string& service, const std::string& type) {
  if (!ends_with(service, goal_service)) return;
  const std::string end = "_SendGoal";
  actions[service.substr(0, service.size() - goal_service.size())].insert(
      ends_with(type, end) ? type.substr(0, type.size() - end.size()) : type);
}

/// Servers hear requests and clients replies: the readers tell who is what.
void add_service(Names& names, const GraphEnd& end, const RosService& service) {
  if (end.writer) return;
  const bool server = service.half == ServiceHalf::request;
  (server ? names.served : names.called)[service.name].insert(ros_service_type(end.type));
  add_action(server ? names.actions_served : names.actions_called, service.name,
             ros_service_type(end.type));
}

void add(Names& names, const GraphEnd& end) {
  if (const auto topic = ros_topic(end.topic)) {
    (end.writer ? names.written : names.read)[*topic].insert(ros_type(end.type));
  } else if (const auto service = ros_service(end.topic)) {
    add_service(names, end, *service);
  }
}

Names names_of(const GraphNode& node, const std::vector<GraphEnd>& ends) {
  Names names;
  for (const GraphEnd& end : ends) {
    if (has_end(node, end)) add(names, end);
  }
  return names;
}

/// An empty section is an empty line.
std::string section(const char* title, const TypesByName& names, bool hidden) {
  std::string text = fmt::format("  {}:\n", title);
  std::string lines;
  for (const auto& [name, types] : names) {
    if (is_hidden(name) && !hidden) continue;
    lines += fmt::format("    {}: {}\n", printable(name), types_text(types));
  }
  return text + (lines.empty() ? "\n" : lines);
}

bool is_hidden_node(const GraphNode& node) { return !node.name.empty() && node.name[0] == '_'; }

}  // namespace

std::string node_list_text(const std::vector<GraphNode>& nodes, const NodeListOptions& options) {
  std::vector<std::string> paths;
  for (const GraphNode& node : nodes) {
    if (options.hidden || !is_hidden_node(node)) paths.push_back(node.path());
  }
  std::sort(paths.begin(), paths.end());
  if (options.count) return fmt::format("{}\n", paths.size());
  std::string text;
  for (const std::string& path : paths) text += printable(path) + "\n";
  return text;
}

bool has_twins(const std::vector<GraphNode>& nodes) {
  std::set<std::string> paths;
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](const GraphNode& node) { return !paths.insert(node.path()).second; });
}

std::string node_info_text(const std::vector<GraphEnd>& ends, const std::vector<GraphNode>& nodes,
                           const std::string& path, bool hidden) {
  const std::string wanted = absolute(path);
  const auto node = std::find_if(nodes.begin(), nodes.end(),
                                 [&](const GraphNode& one) { return one.path() == wanted; });
  if (node == nodes.end()) return "";
  const Names names = names_of(*node, ends);
  return printable(wanted) + "\n" + section("Subscribers", names.read, hidden) +
         section("Publishers", names.written, hidden) +
         section("Service Servers", names.served, hidden) +
         section("Service Clients", names.called, hidden) +
         section("Action Servers", names.actions_served, hidden) +
         section("Action Clients", names.actions_called, hidden);
}

}  // namespace tocsin::topic_tool
