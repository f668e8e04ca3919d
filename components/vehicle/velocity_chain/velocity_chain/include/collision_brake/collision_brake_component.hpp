// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "collision_brake/collision_brake.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "scan_input/pose_history.hpp"
#include "scan_input/scan_input.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Between velocity_mux and velocity_smoother: passes what the laser's scans allow. A velocity is
/// judged when it comes, and again with each scan. It says nothing of its own: when it or what
/// feeds it dies, the smoother brakes.
class CollisionBrakeComponent final : public Component {
 public:
  using Params = CollisionBrake::Params;
  CollisionBrakeComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_odometry(Time now);
  void take_scan(Time now);
  void send(Time now);
  void report(const CollisionBrake::Verdict& verdict, Time now);
  void publish_state(const CollisionBrake::Verdict& verdict);
  void publish_diagnostics(Time now);

  Input<topic::CmdVelSelected> wanted_{*this};
  Input<topic::Odom> odom_{*this, WakeMode::time_triggered};
  ScanInput scan_{*this};
  OptionalInput<topic::CollisionBrakeBypass> bypass_{*this};
  Output<topic::CmdVelChecked> checked_{*this};
  Output<topic::CollisionMonitorState> state_{*this};
  Output<topic::Diagnostics> diagnostics_{*this};

  CollisionBrake brake_;
  PoseHistory poses_;
  geometry::Twist velocity_;
  std::optional<geometry::Twist> asked_;  ///< the last wanted velocity
  Time asked_at_{};
  CollisionBrake::Verdict verdict_;
  bool is_reported_ = false;
  bool was_bypassed_ = false;
  Time next_diagnostics_{};
};

}  // namespace tocsin
