// SPDX-License-Identifier: Apache-2.0
// Parameters of ROS 2 as the protocol shows them. Pure.
#pragma once

#include <optional>
#include <string>

#include "operator_server/client_message.hpp"
#include "ros_idl/rcl_interfaces.hpp"

namespace tocsin::foxglove {

/// `/navigator.speed_mps` is the parameter `speed_mps` of the node `navigator`.
struct ParameterName {
  std::string node;  ///< without a slash in front
  std::string parameter;
};
/// Nothing when it names none.
[[nodiscard]] std::optional<ParameterName> split_parameter_name(const std::string& name);
[[nodiscard]] std::string joined_parameter_name(const ParameterName& name);

[[nodiscard]] Parameter shown_parameter(const std::string& name,
                                        const rcl_interfaces::msg::ParameterValue& value);

/// The value that a client gives. `known_type` (ParameterType_Constants, 0 unknown): the type that
/// the parameter has, since JSON does not tell 1 from 1.0. Nothing for null and mixed lists.
[[nodiscard]] std::optional<rcl_interfaces::msg::ParameterValue> given_value(
    const Parameter& parameter, std::uint8_t known_type);

}  // namespace tocsin::foxglove
