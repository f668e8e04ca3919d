// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "teleop/teleop_component.hpp"
#include "teleop_gamepad/gamepad_teleop.hpp"

namespace tocsin {

/// Manual driving with a gamepad, which may be plugged in and out at any time.
class TeleopGamepadComponent final : public TeleopComponent {
 public:
  struct Params {
    std::string device;
    double retry_s = 1;
    GamepadTeleop::Params pad;
    TeleopComponent::Params common;
    template <class Visitor>
    void visit(Visitor& v) {
      v("device", device, "path of the gamepad; empty: the first that is there");
      v("retry_s", retry_s, {0.1, 60}, "[s] between looks for an absent gamepad");
      pad.visit(v);
      common.visit(v);
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
  void log_authority();

  const Params params_;
  std::unique_ptr<GamepadDevice> pad_;
  GamepadTeleop teleop_;
  std::string logged_;  ///< of who drives
  Time next_look_ = Time::min();
  bool is_missed_ = false;  ///< it is logged that there is no gamepad
};

}  // namespace tocsin
