// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_driver/kobuki_driver.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// The command topics of kobuki_node beside the velocity: LEDs, sounds, outputs, supplies, odometry
/// reset, motor power, gains. Part of the driver's component.
class CommandTopics {
 public:
  explicit CommandTopics(Component& owner);
  /// Hands everything that came to the driver. Returns how many commands made no sense, or could
  /// not be sent (a sound while nobody is online, gains for a firmware without).
  [[nodiscard]] int apply(kobuki::KobukiDriver& driver);

 private:
  [[nodiscard]] bool anything_came() const;
  [[nodiscard]] int apply_outputs(kobuki::KobukiDriver& driver);
  Input<topic::Led1> led1_;
  Input<topic::Led2> led2_;
  Input<topic::SoundCommand> sound_;
  Input<topic::DigitalOutput> digital_;
  Input<topic::ExternalPower> supply_;
  Input<topic::ResetOdometry> reset_;
  Input<topic::MotorPower> motor_;
  Input<topic::GainsCommand> gains_;
};

}  // namespace tocsin
