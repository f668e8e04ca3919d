// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/twist.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "teleop/control_authority.hpp"
#include "teleop/teleop_sender.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// What every component by which a person drives has: its commands, by the rule of TeleopSender,
/// and control authority among several operators. Who inherits ends with `stop`.
class TeleopComponent : public Component {
 public:
  struct Params {
    std::string name;
    TeleopSender::Params sender;
    template <class Visitor>
    void visit(Visitor& v) {
      v("name", name, "who drives, for other operators; empty: device@computer:process");
      sender.visit(v);
    }
  };

 protected:
  /// `device`: part of the operator's name where none is set.
  TeleopComponent(Context& context, const Params& params, const std::string& device);

  /// Takes what the vehicle reports of who drives.
  void take_authority();
  /// Sends the command that is due for this velocity, if any.
  void drive(const geometry::Twist& velocity, Time now);
  /// Leaves the vehicle standing. For destructors.
  void stop();
  [[nodiscard]] Time next_command() const { return sender_.next_deadline(); }
  /// Gives control to who asks for it, or asks who drives.
  void hand_over(Time now);
  /// Takes control from another who drives, without being given it.
  void take_control(Time now);
  void keep_control(Time now) { request(ControlVerb::keep, now); }
  /// What the operator has to know of who drives; empty: nothing.
  [[nodiscard]] std::string authority_text(const ControlKeys& keys) const {
    return control_text(authority_, name_, keys);
  }

 private:
  void request(ControlVerb verb, Time now);
  void send(const geometry::Twist& velocity, Time now);

  OptionalInput<topic::DriverState> driver_{*this};
  Output<topic::TeleopCmdVel> command_{*this};
  Output<topic::DriverRequest> request_{*this};
  const std::string name_;
  TeleopSender sender_;
  ControlAuthority authority_;
};

}  // namespace tocsin
