// SPDX-License-Identifier: Apache-2.0
// Parameters in the messages of ROS 2. Pure.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "foundation/parameter_facts.hpp"
#include "ros_idl/rcl_interfaces.hpp"

namespace tocsin {

using RosValue = rcl_interfaces::msg::ParameterValue;

/// The value with its type; whole numbers are INTEGER, others DOUBLE.
[[nodiscard]] RosValue ros_value(const ParameterValue& value);
/// As it would stand in a bringup file; nothing when it is not set, or of a type that no parameter
/// of ours has (bytes).
[[nodiscard]] std::optional<YAML::Node> yaml_of(const RosValue& value);

/// The narrowest of integer, double, boolean and string that a scalar is; `y` and `n` are texts.
[[nodiscard]] ParameterValue scalar_of(const YAML::Node& node);
/// A value by YAML's rules: `1` is an integer, `1.0` a double, `[a, b]` an array of strings,
/// nothing an empty string. Throws ConfigError, which begins with `shown`, for a map and for a list
/// of several types.
[[nodiscard]] RosValue ros_value_of(const YAML::Node& node, const std::string& shown);

/// "double", "string array": the code of a type in ROS 2's words.
[[nodiscard]] const char* type_word(std::uint8_t type);
/// Why a parameter with this value cannot take the other one's type; empty: it can.
[[nodiscard]] std::string type_fault(const ParameterValue& has, const RosValue& given);

/// Whether a parameter with this value has the other one already: 1 is 1.0, and a list without
/// elements is of any type. So a dump can be loaded that names what cannot be set.
[[nodiscard]] bool has_value(const ParameterValue& has, const RosValue& given);

[[nodiscard]] rcl_interfaces::msg::ParameterDescriptor describe(const ParameterFacts& facts);

/// What `list_parameters` answers: names that begin with one of the prefixes (all, without any) and
/// have at most `depth` parts below it (any, when 0).
[[nodiscard]] rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<ParameterFacts>& all,
    const rcl_interfaces::srv::ListParameters_Request& request);

/// Null: there is none of this name.
[[nodiscard]] const ParameterFacts* find_parameter(const std::vector<ParameterFacts>& all,
                                                   const std::string& name);

}  // namespace tocsin
