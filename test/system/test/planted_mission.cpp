// SPDX-License-Identifier: Apache-2.0
// A small mission control with a bug behind a parameter, for planted_bug_test.
#include <optional>
#include <string>
#include <utility>

#include "navigation/mission.hpp"
#include "runtime/component.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Sends waypoint after waypoint and ends the process after the last one.
class PlantedMission final : public Component {
 public:
  struct Params {
    std::string mission_file;
    bool repeats = true;
    template <class Visitor>
    void visit(Visitor& v) {
      v("mission_file", mission_file, "mission");
      v("repeats", repeats,
        "false: the bug, for a goal that arrived may be forgotten by a restart");
    }
  };

  PlantedMission(Context& context, const Params& params)
      : Component(context),
        repeats_(params.repeats),
        mission_(navigation::load_mission(params.mission_file)) {
    wake_every(seconds(0.5));
  }

  void tick(Time now) override {
    while (const auto status = status_.take()) {
      if (status->goal_id() == waypoint_ + 1 && status->state() == "reached") go_on();
    }
    const bool due = !sent_ || (repeats_ && now - *sent_ >= seconds(3));
    if (!due || waypoint_ == mission_.waypoints.size()) return;
    sent_ = now;
    topic::Goal::Message goal;
    goal.id(waypoint_ + 1);
    goal.x(mission_.waypoints[waypoint_].x_m);
    goal.y(mission_.waypoints[waypoint_].y_m);
    goal.yaw(mission_.waypoints[waypoint_].heading_rad);
    goal.tolerance_m(0.15);
    goal.lifetime_s(60);
    (void)goal_.write(std::move(goal));
  }

 private:
  void go_on() {
    sent_.reset();
    if (++waypoint_ == mission_.waypoints.size()) context().request_exit(0);
  }

  Input<topic::NavigationStatus> status_{*this};
  Output<topic::Goal> goal_{*this};
  bool repeats_;
  navigation::Mission mission_;
  std::size_t waypoint_ = 0;
  std::optional<Time> sent_;
};

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::PlantedMission)
