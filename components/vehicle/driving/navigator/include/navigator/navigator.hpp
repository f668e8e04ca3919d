// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "navigation/occupancy_map.hpp"
#include "navigation/path_follower.hpp"
#include "navigator/goal_list.hpp"
#include "navigator/look_around.hpp"
#include "navigator/reconnection.hpp"
#include "navigator/send_stop.hpp"
#include "navigator/surroundings.hpp"

namespace tocsin {

/// What the vehicle does about its goal while the ground station is not heard.
enum class OnLinkLost { carry_on, hold, go_home, reconnect };
constexpr std::array<const char*, 4> words_of(OnLinkLost) {
  return {"continue", "hold", "return", "reconnect"};
}

/// Drives the vehicle to one goal at a time, on to the next one that it knows, and says what it
/// does about it.
///
/// Pure: no clock, no I/O. `now` must not decrease between calls. It stands still unless it has
/// a goal that has not expired, a fresh pose and no emergency stop.
class Navigator {
 public:
  struct Params {
    navigation::InflationParams inflation;
    navigation::FollowerParams follower;
    double pose_timeout_s = 0.5;
    OnLinkLost on_link_lost = OnLinkLost::hold;
    double link_lost_after_s = 30;
    Reconnection::Params reconnection;
    SendStop::Params send_stop;
    double stuck_after_s = 4;
    double retry_after_s = 3;
    double replan_beside_m = 0.4;
    double slow_near_m = 0.3;
    bool look_around = false;
    Surroundings::Params surroundings;
    [[nodiscard]] bool heeds_link() const {
      return surroundings.link_detour > 0 || on_link_lost == OnLinkLost::reconnect ||
             send_stop.send_stop_s > 0;
    }
    bool align_yaw = true;
    double yaw_tolerance_rad = 0.2;
    template <class Visitor>
    void visit(Visitor& v) {
      inflation.visit(v);
      follower.visit(v);
      v("pose_timeout_s", pose_timeout_s, {0.05, 10}, "[s] older poses stop the vehicle");
      visit_enum(v, "on_link_lost", on_link_lost,
                 Choices{"continue", "hold", "return", "reconnect"},
                 "what to do about the goal while the ground station is not heard; reconnect: "
                 "drives where `link_risk` says that it will be, without one returns");
      live(v)("link_lost_after_s", link_lost_after_s, {0.5, 3600},
              "[s] longer silence is a lost link");
      reconnection.visit(v);
      send_stop.visit(v);
      v("stuck_after_s", stuck_after_s, {0.5, 60}, "[s] without moving: back up, plan again");
      v("retry_after_s", retry_after_s, {0.5, 60}, "[s] blocked for this long before a new try");
      v("replan_beside_m", replan_beside_m, {0.1, 5}, "[m] farther beside the path: plan again");
      v("slow_near_m", slow_near_m, {0, 2}, "[m] slower when nearer to an obstacle; 0: never");
      v("look_around", look_around,
        "whether it turns, and drives where a laser sees the way free, to find out where it is");
      surroundings.visit(v);
      v("align_yaw", align_yaw, "whether to turn to the goal's heading after arriving");
      v("yaw_tolerance_rad", yaw_tolerance_rad, {0.02, 3}, "[rad] heading error that will do");
    }
  };

  enum class State { idle, driving, reached, blocked, held };

  struct Status {
    std::uint64_t mission = 0;
    std::uint64_t goal_id = 0;
    State state = State::idle;
    double distance_m = 0;    // along the path to the goal, NaN: no path
    const char* reason = "";  // as in NavigationStatus
  };

  struct Output {
    geometry::Twist velocity;
    Status status;
  };

  /// Throws ConfigError when the parameters contradict each other.
  Navigator(const Params& params, const navigation::OccupancyMap& map);
  /// The same with costs that were computed before, from this map and `params.inflation`.
  Navigator(const Params& params, navigation::OccupancyMap map,
            std::shared_ptr<const navigation::CostMap> costs);

  /// Other values of the live parameters from now on.
  void set_live(const Params& params);
  [[nodiscard]] GoalAnswer on_goal(Goal goal, Time now);
  /// The same of somebody on the vehicle, by which the ground station is not heard.
  [[nodiscard]] GoalAnswer on_local_goal(Goal goal, Time now) {
    return goals_.on_goal(std::move(goal), now);
  }
  /// Brakes, and drives to the present goal no more.
  void drop_goal(Time now) { goals_.expire(now); }
  /// What it drives to.
  [[nodiscard]] const std::optional<Goal>& goal() const { return goals_.present(); }
  /// Whether it has a goal that it has not reached and may still drive to.
  [[nodiscard]] bool is_busy(Time now) const;
  /// Another map, in the same frame: it has grown. Plans anew.
  void set_map(const navigation::OccupancyMap& map) { surroundings_.set_map(map); }
  /// Where the link is lost.
  void set_link(navigation::LinkRisk risk) { surroundings_.set_link(std::move(risk)); }
  /// What the router says of the vehicle's stored topics.
  void on_store(const StoreBacklog& store, Time now) { send_stop_.on_store(store, now); }
  /// What may be driven on.
  [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }
  void clear_obstacles() { surroundings_.clear_obstacles(); }
  /// Pose of the vehicle in the map frame; one that is not finite is ignored.
  void on_pose(const geometry::Pose& pose, Time now);
  /// A turn of the laser, measured by a vehicle at `pose` in the map frame; empty: not known where.
  void on_scan(const laser::Scan& scan, const std::optional<geometry::Pose>& pose, Time now);
  /// Something is in the way, or the floor ends, at so many metres from the vehicle's middle in a
  /// direction from ahead to the left.
  void on_touch(double bearing_rad, double away_m, Time now);
  /// Stops the vehicle at once, until it is called with false.
  void on_emergency_stop(bool is_pressed) { emergency_stop_ = is_pressed; }
  /// The ground station was heard. Until it was heard once, the link does not count as lost.
  void on_ground_station(Time now) { heard_ = now; }

  /// The way that it follows, empty without one; `plans` rises with each new one.
  [[nodiscard]] const geometry::Path& path() const { return follower_.path(); }
  [[nodiscard]] std::uint64_t plans() const { return plans_; }
  /// How it was chosen; empty where the link is not known, or not heeded.
  [[nodiscard]] const std::optional<navigation::WayChoice>& choice() const {
    return surroundings_.choice();
  }

  /// The velocity to drive from now on. To be called 10 to 50 times a second.
  [[nodiscard]] Output update(Time now);

 private:
  struct Target {
    std::uint64_t key;  // the goal's number, 0: home, the highest bit: to a place with a link
    geometry::Pose pose;
    double tolerance_m;
  };

  [[nodiscard]] const char* reason_to_halt(Time now) const;
  [[nodiscard]] const char* reason_to_hold(Time now) const;
  [[nodiscard]] bool is_link_lost(Time now) const;
  [[nodiscard]] bool stands_at_goal() const;
  [[nodiscard]] bool sends_at_goal(Time now);
  [[nodiscard]] bool sends_on_way(const Target& target, Time now);
  [[nodiscard]] Status status(State state, double distance_m, const char* reason) const;
  Output stand(State state, const geometry::Twist& velocity, const char* reason);
  [[nodiscard]] geometry::Twist look_around(Time now, Duration dt);
  [[nodiscard]] bool knows_pose(Time now) const;
  [[nodiscard]] bool reconnects(Time now);
  Output drive_unheard(const Target& target, Time now, Duration dt);
  Output go_home(Time now, Duration dt);
  Output reconnect(Time now, Duration dt);
  Output drive(const Target& target, Time now, Duration dt);
  Output drive_path(const Target& target, Time now, Duration dt);
  geometry::Twist follow_with_care(Duration dt);
  [[nodiscard]] double allowed_mps() const;
  Output align(const Target& target, Duration dt);
  Output block(Time now, const char* reason);
  [[nodiscard]] bool waits_blocked(Time now) const;
  Output wait_blocked(Time now, Duration dt);
  [[nodiscard]] bool has_arrived(const Target& target) const;
  void take_up(const Target& target);
  [[nodiscard]] bool would_hit() const;
  [[nodiscard]] bool is_free_behind() const;
  [[nodiscard]] bool is_stuck(Time now);

  Params params_;
  Surroundings surroundings_;
  navigation::PathFollower follower_;

  GoalList goals_;
  std::optional<geometry::Pose> home_;  // the first pose
  LookAround look_around_;
  Reconnection reconnection_;
  SendStop send_stop_;
  std::optional<std::uint64_t> resumed_goal_;  // that it drives on to after it was heard again
  geometry::Pose pose_;
  Time pose_time_{};
  std::optional<Time> heard_;
  std::optional<Time> last_update_;
  bool emergency_stop_ = false;

  // About the target being driven to.
  std::optional<std::uint64_t> target_key_;
  bool has_path_ = false;
  std::uint64_t plans_ = 0;
  bool arrived_ = false;  // near enough, perhaps still turning
  bool reached_ = false;
  std::optional<Time> blocked_since_;
  const char* blocked_reason_ = "";
  geometry::Pose progress_pose_;  // where it last was seen to move
  Time progress_time_{};          // or last had no reason to
};

/// The word of NavigationStatus.state.
[[nodiscard]] const char* to_string(Navigator::State state);

}  // namespace tocsin
