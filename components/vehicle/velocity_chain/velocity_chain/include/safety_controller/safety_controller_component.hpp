// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "emergency_stop_input/emergency_stop_input.hpp"
#include "emergency_stop_input/stop_file.hpp"
#include "geometry/twist.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "safety_controller/safety_controller.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The last in the way of a velocity to the base: bumper, cliff, wheel drop and emergency stop.
/// Woken by events and velocities only. When it dies the base gets no velocity, and stops.
class SafetyControllerComponent final : public Component {
 public:
  using Params = SafetyController::Params;
  SafetyControllerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_state_at_start(Time now);
  void take_events(Time now);
  void take_emergency_stop(Time now);
  void send(const geometry::Twist& velocity);
  void report(Time now);

  Input<topic::CmdVelSmoothed> wanted_{*this};
  Input<topic::BumperEvents> bumper_{*this};
  Input<topic::CliffEvents> cliff_{*this};
  Input<topic::WheelDropEvents> wheel_drop_{*this};
  EmergencyStopInput emergency_stop_{*this};
  OptionalInput<topic::SafetyEnable> enable_{*this};
  /// Until the first sample: what is pressed already makes no event. Fifty a second is too many
  /// for longer.
  std::optional<Input<topic::SensorsCore>> sensors_;
  Output<topic::CmdVel> cmd_vel_{*this};
  Output<topic::SafetyStatus> status_{*this};

  StopFile file_;
  SafetyController controller_;
  Hazards hazards_;
  std::optional<topic::SafetyStatus::Message> reported_;
};

}  // namespace tocsin
