// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mission_control/mission_control.hpp"
#include "mission_control/waypoints_server.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Leads the vehicle through a mission file and through goals of the action follow_waypoints.
class MissionControlComponent final : public Component {
 public:
  struct Params {
    std::string mission_file;
    std::string map_file;
    double robot_radius_m = 0.18;
    double rate_hz = 5;
    double status_period_s = 1;
    bool exit_when_over = false;
    MissionControl::Params control;
    template <class Visitor>
    void visit(Visitor& v) {
      v("mission_file", mission_file,
        "mission, YAML or JSON lines (*.jsonl); empty: waits for goals of follow_waypoints");
      v("map_file", map_file, "map that the waypoints are checked against; empty: unchecked");
      v("robot_radius_m", robot_radius_m, {0.05, 1}, "[m] a waypoint nearer to a wall is refused");
      v("rate_hz", rate_hz, {1, 20}, "[Hz] of looking whether a goal is due");
      v("status_period_s", status_period_s, {0.1, 60}, "[s] between reports without a change");
      v("exit_when_over", exit_when_over,
        "end the process when a mission is over, with mission_file that one: code 0 when done, 1 "
        "when aborted");
      control.visit(v);
    }
  };

  /// Throws ConfigError when mission or map cannot be read, or a waypoint is not free.
  MissionControlComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_inputs(Time now);
  void take_orders(Time now);
  void send(const MissionControl::Goal& goal, Time now);
  void log_arrivals();
  [[nodiscard]] std::string mission_name() const;
  void report(Time now);
  void publish_path(Time now);
  void end_when_over(MissionControl::State state);

  Input<topic::Location> location_{*this, WakeMode::time_triggered};
  Input<topic::NavigationStatus> navigation_{*this};
  OptionalInput<topic::MissionCommand> orders_{*this};
  Output<topic::Goal> goal_{*this};
  Output<topic::MissionStatus> status_{*this};
  Output<topic::MissionPath> path_{*this};

  Params params_;
  MissionControl control_;
  WaypointsServer waypoints_;
  std::size_t arrivals_logged_ = 0;
  std::optional<std::uint32_t> published_missions_;  // whose path is published
  Time next_report_{};
  MissionControl::Progress reported_;
};

}  // namespace tocsin
