// SPDX-License-Identifier: Apache-2.0
// What `ros2 param` prints and takes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "runtime/middleware/ros_parameters.hpp"

namespace tocsin::topic_tool {

using NamedValue = std::pair<std::string, RosValue>;

/// `0.3`, `True`, `['a', 'b']`: the value as Python shows it; empty when it is not set.
[[nodiscard]] std::string value_text(const RosValue& value);
/// `Double value is: 0.3`, as `ros2 param get` prints it.
[[nodiscard]] std::string typed_value_text(const RosValue& value);
/// As `ros2 param describe` prints it, several lines.
[[nodiscard]] std::string description_text(
    const rcl_interfaces::msg::ParameterDescriptor& descriptor);
/// As `ros2 param dump` prints it: YAML that a node of ROS 2 takes as its parameters.
[[nodiscard]] std::string dump_text(const std::string& node, const std::vector<NamedValue>& values);

/// A value by YAML's rules: `1` is an integer, `1.0` a double, `[a, b]` an array of strings. Throws
/// ConfigError for a map and for a list of several types.
[[nodiscard]] RosValue value_in(const std::string& yaml);
/// What a file as of `dump_text` says for the node, by its path or under "/**". Throws ConfigError.
[[nodiscard]] std::vector<NamedValue> values_in_file(const std::string& file,
                                                     const std::string& node);

}  // namespace tocsin::topic_tool
