// SPDX-License-Identifier: Apache-2.0
// Message types in the syntax of ROS 2's .msg files, for recordings that others read.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// The fields of one type.
struct TypeDefinition {
  std::string name;                ///< on the wire: `geometry_msgs::msg::dds_::Twist_`
  std::string text;                ///< a line for each of its own fields
  std::vector<std::string> parts;  ///< wire names of the types that its fields are of
};

/// Makes a definition known. Called by generated code before main.
void register_definition(TypeDefinition definition);

/// What the fields of other types call it: `geometry_msgs/Twist` of
/// `geometry_msgs::msg::dds_::Twist_`.
[[nodiscard]] std::string short_type_name(const std::string& wire_name);

/// Wire names of all types that have a definition, sorted. Any thread.
[[nodiscard]] std::vector<std::string> known_definitions();
/// By its wire name; empty when no loaded library has the type, or .msg cannot say it. Any thread.
[[nodiscard]] std::optional<TypeDefinition> find_definition(const std::string& name);

/// The fields of a type, by its wire name, and behind them those of all types in it, each after a
/// line of 80 `=` and a line `MSG: package/Type`: what MCAP calls `ros2msg`. Empty when no loaded
/// library has the type, or .msg cannot say it. Any thread.
[[nodiscard]] std::optional<std::string> ros2msg_definition(const std::string& name);

}  // namespace tocsin
