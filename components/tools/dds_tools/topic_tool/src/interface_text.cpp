// SPDX-License-Identifier: Apache-2.0
#include "interface_text.hpp"

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/type_definition.hpp"

namespace tocsin::topic_tool {
namespace {

using Words = std::vector<std::string>;

/// What an empty message has on the wire, and nobody writes.
const std::string nothing = "structure_needs_at_least_one_member";

/// "pkg", "srv", "Name": nothing where it is no interface of ROS 2.
std::optional<Words> words_of(const std::string& ros_type) {
  const std::size_t first = ros_type.find('/');
  const std::size_t second = first == std::string::npos ? first : ros_type.find('/', first + 1);
  if (second == std::string::npos || ros_type.find('/', second + 1) != std::string::npos) return {};
  return Words{ros_type.substr(0, first), ros_type.substr(first + 1, second - first - 1),
               ros_type.substr(second + 1)};
}

/// `text` without the one of `ends` that it ends with.
std::string without_end(const std::string& text, const Words& ends) {
  for (const std::string& end : ends) {
    if (text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0) {
      return text.substr(0, text.size() - end.size());
    }
  }
  return text;
}

std::string section(const char* title, const std::set<std::string>& names) {
  std::string text = std::string(title) + ":\n";
  for (const std::string& name : names) text += "    " + printable(name) + "\n";
  return text;
}

/// The lines of a type, each followed by those of the type that it is of, one tab deeper.
std::string expanded(const TypeDefinition& type, const std::string& indent) {
  constexpr std::size_t deepest = 20;
  std::string text;
  std::size_t next_part = 0;
  for (std::size_t at = 0; at < type.text.size();) {
    const std::size_t end = std::min(type.text.find('\n', at), type.text.size());
    const std::string line = type.text.substr(at, end - at);
    at = end + 1;
    if (line.find(nothing) != std::string::npos) continue;
    text += indent + line + "\n";
    const std::string word = line.substr(0, line.find(' '));
    const std::string of = word.substr(0, word.find('['));
    if (of.find('/') == std::string::npos || indent.size() >= deepest) continue;
    for (next_part = 0; next_part < type.parts.size(); ++next_part) {
      if (short_type_name(type.parts[next_part]) != of) continue;
      if (const auto part = find_definition(type.parts[next_part])) {
        text += expanded(*part, indent + "\t");
      }
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> parts_of(const std::string& interface) {
  const auto words = words_of(interface);
  if (!words) throw ConfigError("'" + printable(interface) + "' is no interface: pkg/msg/Name");
  if ((*words)[1] == "srv") return {interface + "_Request", interface + "_Response"};
  if ((*words)[1] != "action") return {interface};
  return {interface + "_Goal", interface + "_Result", interface + "_Feedback"};
}

std::set<std::string> Interfaces::all() const {
  std::set<std::string> names = messages;
  names.insert(services.begin(), services.end());
  names.insert(actions.begin(), actions.end());
  return names;
}

Interfaces interfaces_in(const std::vector<std::string>& wire_names) {
  Interfaces found;
  for (const std::string& wire : wire_names) {
    const std::string name = ros_type(wire);
    const auto words = words_of(name);
    if (!words) continue;
    const std::string& kind = (*words)[1];
    if (kind == "msg") found.messages.insert(name);
    if (kind == "srv") found.services.insert(without_end(name, {"_Request", "_Response"}));
    if (kind != "action") continue;
    found.actions.insert(without_end(
        name, {"_SendGoal_Request", "_SendGoal_Response", "_GetResult_Request",
               "_GetResult_Response", "_FeedbackMessage", "_Goal", "_Result", "_Feedback"}));
  }
  return found;
}

std::string interface_list_text(const Interfaces& interfaces, const InterfaceListOptions& options) {
  const bool all = !options.messages && !options.services && !options.actions;
  std::string text;
  if (all || options.messages) text += section("Messages", interfaces.messages);
  if (all || options.services) text += section("Services", interfaces.services);
  if (all || options.actions) text += section("Actions", interfaces.actions);
  return text;
}

std::string package_text(const Interfaces& interfaces, const std::string& package) {
  std::string text;
  for (const std::string& name : interfaces.all()) {
    if (name.substr(0, name.find('/')) == package) text += printable(name) + "\n";
  }
  return text;
}

std::string packages_text(const Interfaces& interfaces) {
  std::set<std::string> packages;
  for (const std::string& name : interfaces.all()) packages.insert(name.substr(0, name.find('/')));
  std::string text;
  for (const std::string& one : packages) text += printable(one) + "\n";
  return text;
}

std::optional<std::string> show_text(const std::string& interface) {
  std::string text;
  bool first = true;
  for (const std::string& part : parts_of(interface)) {
    const auto definition = find_definition(wire_type(part));
    if (!definition) return std::nullopt;
    if (!first) text += "---\n";
    first = false;
    text += expanded(*definition, "");
  }
  return text;
}

std::string first_part(const std::string& interface) {
  return wire_type(parts_of(interface).front());
}

}  // namespace tocsin::topic_tool
