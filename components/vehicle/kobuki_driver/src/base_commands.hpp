// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_idl/kobuki_ros_interfaces.hpp"

namespace tocsin::kobuki {

/// What a command message asks for; each is empty, or false, when the message makes no sense.

/// The output register with LED 1 or 2 changed.
[[nodiscard]] std::optional<OutputRegister> with_led(OutputRegister outputs, int led,
                                                     std::uint8_t colour);
/// The output register with the masked outputs changed.
[[nodiscard]] OutputRegister with_outputs(OutputRegister outputs,
                                          const kobuki_ros_interfaces::msg::DigitalOutput& wanted);
[[nodiscard]] std::optional<OutputRegister> with_supply(
    OutputRegister outputs, const kobuki_ros_interfaces::msg::ExternalPower& wanted);
[[nodiscard]] std::optional<Tune> tune_of(const kobuki_ros_interfaces::msg::Sound& sound);
/// Gains are kept to 0.001; negative, too large or NaN is none.
[[nodiscard]] std::optional<ControllerGains> gains_of(
    const kobuki_ros_interfaces::msg::ControllerInfo& info);
[[nodiscard]] kobuki_ros_interfaces::msg::ControllerInfo to_message(const ControllerGains& gains);

}  // namespace tocsin::kobuki
