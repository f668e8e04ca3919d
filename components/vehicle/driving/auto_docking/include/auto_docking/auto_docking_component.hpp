// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "auto_docking/auto_docking.hpp"
#include "geometry/twist.hpp"
#include "kobuki_idl/actions.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/action_port.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Drives the base into its dock when it is told to, and says how that went. Listens to the base's
/// sensors only meanwhile.
class AutoDockingComponent final : public Component {
 public:
  using Params = AutoDocking::Params;
  AutoDockingComponent(Context& context, const Params& params)
      : Component(context), docking_(params), silence_(seconds(params.silence_s)) {}
  void tick(Time now) override;

 private:
  struct Sensors {
    explicit Sensors(Component& owner) : core(owner), infrared(owner), odom(owner) {}
    Input<topic::SensorsCore> core;
    Input<topic::DockInfrared> infrared;
    Input<topic::Odom> odom;
  };
  void take_commands(Time now);
  void take_goals(Time now);
  void finish_goal(Time now);
  void start(Time now);
  void take_sensors(Time now);
  void send(const geometry::Twist& velocity);
  void report(Time now);

  OptionalInput<topic::DockingCommand> command_{*this};
  Output<topic::CmdVelDocking> cmd_vel_{*this};
  Output<topic::DockingStatus> status_{*this};
  ActionServer<action::AutoDocking> action_{*this};

  AutoDocking docking_;
  Duration silence_;
  std::optional<Sensors> sensors_;
  DockingInput seen_;
  std::uint32_t run_ = 0;
  Time started_{};
  std::optional<GoalId> goal_;  ///< of the action, while it docks for it
  std::optional<DockingState> reported_;
  Time next_report_{};
};

}  // namespace tocsin
