// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace tocsin {

/// Topics of the chain before the wheels, by name: whoever writes one of them on the vehicle's host
/// moves the vehicle, or decides what stops it. Between them and the link stand components that
/// judge what comes: teleop_receiver, navigator, auto_docking.
inline constexpr std::array chain_topics{
    "cmd_vel",
    "cmd_vel/navigation",
    "cmd_vel/docking",
    "cmd_vel/teleop",
    "cmd_vel/selected",
    "cmd_vel/checked",
    "cmd_vel/smoothed",
    "velocity_mux/set_inputs",
    "collision_brake/bypass",
    "safety_controller/enable",
    "commands/motor_power",
    "commands/reset_odometry",
    "commands/controller_info",
    "commands/digital_output",
    "commands/external_power",
    "emergency_stop",
    "emergency_stop/request",
    "link_stop",
};

/// Whether a topic is one of them, or another below `cmd_vel/` or `commands/`. What was logged of
/// one and crosses later, on `<topic>/backfilled` is none: nothing drives by it.
[[nodiscard]] bool is_of_chain(const std::string& topic);

}  // namespace tocsin
