// SPDX-License-Identifier: Apache-2.0
// What `ros2 interface` prints.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tocsin::topic_tool {

/// Names of interfaces as ROS 2 writes them: `std_srvs/srv/Trigger`.
struct Interfaces {
  std::set<std::string> messages;
  std::set<std::string> services;
  std::set<std::string> actions;

  [[nodiscard]] std::set<std::string> all() const;
};
/// Those behind the names of types on the wire: the parts of a service and of an action are one.
[[nodiscard]] Interfaces interfaces_in(const std::vector<std::string>& wire_names);

struct InterfaceListOptions {
  bool messages = false;  ///< -m: only these; without any of the three, all
  bool services = false;
  bool actions = false;
};
/// By kind, a line each.
[[nodiscard]] std::string interface_list_text(const Interfaces& interfaces,
                                              const InterfaceListOptions& options);
/// Those of one package, a line each.
[[nodiscard]] std::string package_text(const Interfaces& interfaces, const std::string& package);
/// Names of packages, a line each.
[[nodiscard]] std::string packages_text(const Interfaces& interfaces);

/// Names of the types that its file has, in their order: the message, request and response, or
/// goal, result and feedback. Throws ConfigError for what is no name of an interface.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& interface);

/// The fields of an interface and of what they are made of, with `---` between the parts of a
/// service or an action. Nothing when no loaded library has it.
[[nodiscard]] std::optional<std::string> show_text(const std::string& interface);
/// The wire name of what a person writes for it: the message, the request, or the goal.
[[nodiscard]] std::string first_part(const std::string& interface);

}  // namespace tocsin::topic_tool
