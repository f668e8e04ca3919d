// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "geometry/twist.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "teleop_gamepad/gamepad_teleop.hpp"
#include "teleop_sender/teleop_sender.hpp"
#include "teleop_sender/wheel.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Manual driving with a gamepad, which may be plugged in and out at any time.
class TeleopGamepadComponent final : public Component {
 public:
  struct Params {
    std::string device;
    double retry_s = 1;
    GamepadTeleop::Params pad;
    TeleopSender::Params sender;
    std::string name;
    template <class Visitor>
    void visit(Visitor& v) {
      v("device", device, "path of the gamepad; empty: the first that is there");
      v("retry_s", retry_s, {0.1, 60}, "[s] between looks for an absent gamepad");
      v("name", name, "who drives, as others are told; empty: gamepad@computer:process");
      pad.visit(v);
      sender.visit(v);
    }
  };

  TeleopGamepadComponent(Context& context, const Params& params);
  /// Leaves the vehicle standing.
  ~TeleopGamepadComponent() override;
  void tick(Time now) override;

 private:
  void look_for_pad(Time now);
  void read_events();
  void lose_pad();
  void watch_wheel();
  void hand_over(Time now);
  void send(const geometry::Twist& velocity, Time now);

  OptionalInput<topic::DriverState> driver_{*this};
  Output<topic::TeleopCmdVel> command_{*this};
  Output<topic::DriverRequest> request_{*this};
  Params params_;
  Devices& devices_;
  std::unique_ptr<GamepadDevice> pad_;
  GamepadTeleop teleop_;
  TeleopSender sender_;
  const std::string name_;
  Wheel wheel_;
  std::string said_;  ///< of the wheel
  Time next_look_ = Time::min();
  bool told_ = false;  ///< that there is no gamepad
};

}  // namespace tocsin
