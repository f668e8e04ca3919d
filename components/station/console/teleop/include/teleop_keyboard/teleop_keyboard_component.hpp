// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "devices/terminal_device.hpp"
#include "teleop/teleop_component.hpp"
#include "teleop_keyboard/keyboard_teleop.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Manual driving by the keys of the terminal that its process has.
class TeleopKeyboardComponent final : public TeleopComponent {
 public:
  struct Params {
    KeyboardTeleop::Params keys;
    TeleopComponent::Params common;
    template <class Visitor>
    void visit(Visitor& v) {
      keys.visit(v);
      common.visit(v);
    }
  };

  TeleopKeyboardComponent(Context& context, const Params& params);
  /// Leaves the vehicle standing.
  ~TeleopKeyboardComponent() override;
  void tick(Time now) override;

 private:
  void read_keys(Time now);
  void show(const geometry::Twist& velocity);

  Input<topic::SafetyStatus> safety_{*this};
  Input<topic::Location> location_{*this};
  std::unique_ptr<TerminalDevice> terminal_;  ///< null: nobody can type
  KeyboardTeleop teleop_;
  std::shared_ptr<const topic::SafetyStatus::Message> safety_seen_;
  std::shared_ptr<const topic::Location::Message> location_seen_;
  std::string shown_;
};

}  // namespace tocsin
