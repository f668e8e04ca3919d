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
  OptionalInput<topic::Led1> led1_;
  OptionalInput<topic::Led2> led2_;
  OptionalInput<topic::SoundCommand> sound_;
  OptionalInput<topic::DigitalOutput> digital_;
  OptionalInput<topic::ExternalPower> supply_;
  OptionalInput<topic::ResetOdometry> reset_;
  OptionalInput<topic::MotorPower> motor_;
  OptionalInput<topic::GainsCommand> gains_;
};

}  // namespace tocsin
