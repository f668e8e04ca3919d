// SPDX-License-Identifier: Apache-2.0
#include "action_text.hpp"

#include <fmt/format.h>

#include <optional>

#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "graph_names.hpp"

namespace tocsin::topic_tool {
namespace {

/// `text` without `end`, if it ends so.
std::optional<std::string> without(const std::string& text, const std::string& end) {
  const bool ends_so =
      text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
  return ends_so ? std::optional(text.substr(0, text.size() - end.size())) : std::nullopt;
}

/// As rcl_action knows them: servers write the feedback, and clients read it.
std::optional<std::string> action_of(const GraphEnd& end) {
  const auto topic = ros_topic(end.topic);
  return topic ? without(*topic, "/_action/feedback") : std::nullopt;
}

std::string type_of(const GraphEnd& end) {
  const std::string type = ros_type(end.type);
  return without(type, "_FeedbackMessage").value_or(type);
}

std::string section(const char* title, const std::map<std::string, std::set<std::string>>& nodes,
                    const ActionListOptions& options) {
  std::string text = fmt::format("{}: {}\n", title, nodes.size());
  if (options.count) return text;
  for (const auto& [path, types] : nodes) {
    text += "    " + printable(path);
    if (options.types) text += " [" + types_text(types) + "]";
    text += "\n";
  }
  return text;
}

}  // namespace

std::map<std::string, ActionEnds> actions_in(const std::vector<GraphEnd>& ends,
                                             const std::vector<GraphNode>& nodes) {
  std::map<std::string, ActionEnds> actions;
  for (const GraphEnd& end : ends) {
    const auto name = action_of(end);
    if (!name) continue;
    ActionEnds& action = actions[*name];
    action.types.insert(type_of(end));
    for (const GraphNode& node : nodes) {
      if (!has_end(node, end)) continue;
      (end.writer ? action.servers : action.clients)[node.path()].insert(type_of(end));
    }
  }
  return actions;
}

std::string action_list_text(const std::map<std::string, ActionEnds>& actions,
                             const ActionListOptions& options) {
  if (options.count) return fmt::format("{}\n", actions.size());
  std::string text;
  for (const auto& [name, ends] : actions) {
    text += printable(name) + (options.types ? " [" + types_text(ends.types) + "]" : "") + "\n";
  }
  return text;
}

std::string action_info_text(const std::string& name, const ActionEnds& ends,
                             const ActionListOptions& options) {
  return fmt::format("Action: {}\n", printable(name)) +
         section("Action clients", ends.clients, options) +
         section("Action servers", ends.servers, options);
}

}  // namespace tocsin::topic_tool
