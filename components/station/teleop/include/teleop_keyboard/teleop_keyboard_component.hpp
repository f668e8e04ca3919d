// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "geometry/twist.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "teleop_keyboard/keyboard_teleop.hpp"
#include "teleop_sender/teleop_sender.hpp"
#include "teleop_sender/wheel.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Manual driving by the keys of the terminal that its process has.
class TeleopKeyboardComponent final : public Component {
 public:
  struct Params {
    KeyboardTeleop::Params keys;
    TeleopSender::Params sender;
    std::string name;
    template <class Visitor>
    void visit(Visitor& v) {
      v("name", name, "who drives, as others are told; empty: keyboard@computer:process");
      keys.visit(v);
      sender.visit(v);
    }
  };

  TeleopKeyboardComponent(Context& context, const Params& params);
  /// Leaves the vehicle standing.
  ~TeleopKeyboardComponent() override;
  void tick(Time now) override;

 private:
  void read_keys(Time now);
  void request(const std::string& verb, Time now);
  void send(const geometry::Twist& velocity, Time now);
  void show(const geometry::Twist& velocity);

  Input<topic::SafetyStatus> safety_{*this};
  Input<topic::Location> location_{*this};
  OptionalInput<topic::DriverState> driver_{*this};
  Output<topic::TeleopCmdVel> command_{*this};
  Output<topic::DriverRequest> request_{*this};

  std::unique_ptr<TerminalDevice> terminal_;  ///< null: nobody can type
  KeyboardTeleop teleop_;
  TeleopSender sender_;
  const std::string name_;
  Wheel wheel_;
  std::shared_ptr<const topic::SafetyStatus::Message> safety_seen_;
  std::shared_ptr<const topic::Location::Message> location_seen_;
  std::string shown_;
};

}  // namespace tocsin
