// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "mission_control/mission_order.hpp"
#include "navigation/mission.hpp"

namespace tocsin {

/// A goal as the vehicle's status names it.
struct GoalName {
  std::uint64_t mission = 0;
  std::uint64_t id = 0;  // 0: none
};

/// Leads the vehicle through one mission after the other: sends waypoint after waypoint as goals,
/// and judges arrival by the reported location or by the navigator's own word, whichever comes
/// first. Where the vehicle stands to send what it has stored, its word alone counts.
///
/// Pure: no clock, no I/O. `now` must not decrease between calls. A goal is a lease: it is renewed
/// while mission control lives, so that a vehicle out of reach stops when the lease is over, and
/// it is repeated until the vehicle's status names it and is not "held". It carries the waypoints
/// that follow, whose ids are its own plus 1, 2, ..., so that a vehicle that hears nothing drives
/// on; its status then names a later one. Silence never aborts a mission.
///
/// A goal's id is its waypoint, from 1. The mission's identity is drawn (32 bits) and holds a
/// checksum of the waypoints (32 bits), so that one that was started anew learns from the vehicle's
/// status alone whether it drives this mission, and where it is. It is drawn again when the vehicle
/// drives to a goal that was not sent by this mission control: the vehicle lets a mission that it
/// has not seen take over, whatever numbers the goal before had. The goal that holds the vehicle in
/// a pause or at a stop has an id far above, so that a mission control that was started anew learns
/// of the pause.
class MissionControl {
 public:
  struct Params {
    double arrival_m = 0.15;
    double tolerance_m = 0.15;
    double repeat_after_s = 3;
    double goal_lifetime_s = 60;
    double resume_wait_s = 2;
    double blocked_limit_s = 60;
    double waypoint_limit_s = 900;
    int goals_ahead = 8;
    bool resume = true;
    template <class Visitor>
    void visit(Visitor& v) {
      v("arrival_m", arrival_m, {0.05, 5}, "[m] a location nearer to the waypoint is arrival");
      v("tolerance_m", tolerance_m, {0.05, 5}, "[m] the navigator's own limit for arrival");
      v("repeat_after_s", repeat_after_s, {0.2, 60}, "[s] without an answer: send the goal again");
      v("goal_lifetime_s", goal_lifetime_s, {2, 3600},
        "[s] the vehicle holds when it was not renewed");
      v("resume_wait_s", resume_wait_s, {0, 60}, "[s] for the vehicle to tell its goal, at start");
      v("blocked_limit_s", blocked_limit_s, {1, 3600}, "[s] blocked for longer: abort");
      v("waypoint_limit_s", waypoint_limit_s, {10, 86400}, "[s] for one waypoint, then abort");
      v("goals_ahead", goals_ahead, {0, 32}, "[1] waypoints that a goal tells besides its own");
      v("resume", resume, "whether to go on with the waypoint that the vehicle drives to already");
    }
  };

  enum class State { idle, waiting, running, paused, done, aborted };  // idle: has no mission

  struct Goal {
    GoalName name;
    std::uint32_t waypoint = 0;
    navigation::Waypoint pose;
    double tolerance_m = 0;
    double lifetime_s = 0;
    std::vector<navigation::Waypoint> ahead;
  };

  /// How an arrival was told.
  struct Arrival {
    std::uint32_t waypoint;
    bool by_location;     // else by the navigator's status
    double distance_m;    // of the last location from the waypoint, NaN: none was reported
    double after_s;       // since the waypoint's first goal
    std::uint32_t goals;  // that were sent for it
  };

  struct Progress {
    State state = State::waiting;
    std::uint32_t waypoint = 0;
    std::uint32_t waypoints = 0;
    std::uint32_t goals_sent = 0;
    double elapsed_s = 0;  // from the first goal to now, or to the end
    std::string reason;    // of aborted
  };

  /// `mission`: nothing: idle until it is given one. Throws ConfigError when it has no waypoint, or
  /// the goal's lifetime is not longer than twice the repetition. `seed`: of what is drawn; another
  /// one for each start.
  MissionControl(const Params& params, std::optional<navigation::Mission> mission,
                 std::uint64_t seed);

  /// Begins a mission of at least one waypoint, in place of the present one, if any, from its first
  /// waypoint and as soon as the vehicle was heard.
  void lead(navigation::Mission mission);
  /// Aborts the mission and has the vehicle halt where it was last seen, by one goal.
  void stop(std::string reason, Time now);
  /// Whether a vehicle that was stopped is known to halt: it says so (it may still brake), or it
  /// drives for somebody else, or the lease of its last waypoint is over.
  [[nodiscard]] bool has_stopped(Time now) const;

  /// Where the vehicle is, map frame; one that is not finite is ignored.
  void on_location(const geometry::Pose& location, Time now);
  /// The vehicle's navigator says what it does: `state` as in NavigationStatus.
  void on_status(const GoalName& goal, const std::string& state, Time now);

  /// A pause holds the vehicle where it was last seen, by one goal, and leaves it to others when it
  /// has named that; the mission goes on with the same waypoint. A skip is for the present waypoint
  /// only, and not for the last one. Time of a pause does not count for `waypoint_limit_s`. What
  /// does not fit to the state is ignored.
  void obey(const MissionOrder& order, Time now);

  /// The goal to send now, if any. To be called a few times a second.
  [[nodiscard]] std::optional<Goal> update(Time now);

  /// Without waypoints while it is idle.
  [[nodiscard]] const navigation::Mission& mission() const { return mission_; }
  /// Missions that were begun so far; another number: mission() is another one.
  [[nodiscard]] std::uint32_t missions() const { return missions_; }
  [[nodiscard]] Progress progress(Time now) const;
  /// All arrivals of the mission so far, in order.
  [[nodiscard]] const std::vector<Arrival>& arrivals() const { return arrivals_; }

 private:
  void start_when_ready(Time now);
  void begin(navigation::Mission mission);
  void resume_earlier();
  void pause(Time now);
  void go_on(Time now);
  void skip(std::uint32_t waypoint, Time now);
  void check_arrival(Time now);
  [[nodiscard]] bool has_gone_on() const;
  void arrive(bool by_location, Time now);
  void check_limits(Time now);
  void finish(State state, std::string reason, Time now);
  [[nodiscard]] bool is_due(Time now) const;
  [[nodiscard]] std::optional<Goal> hold(Time now);
  Goal issue(Time now);
  [[nodiscard]] GoalName present() const { return {identity_, waypoint_ + std::uint64_t{1}}; }
  [[nodiscard]] GoalName held() const { return {identity_, hold_base + present().id}; }
  [[nodiscard]] bool is_told_present() const;
  [[nodiscard]] bool is_told_waypoint() const;
  [[nodiscard]] bool was_taken_over() const;
  void draw_identity();
  [[nodiscard]] std::vector<navigation::Waypoint> waypoints_ahead() const;
  [[nodiscard]] double distance_m() const;

  /// Ids of goals that hold the vehicle during a pause or after a stop: this and the waypoint's
  /// own.
  static constexpr std::uint64_t hold_base = std::uint64_t{1} << 32U;

  Params params_;
  navigation::Mission mission_;
  std::uint32_t missions_ = 0;
  std::uint32_t checksum_ = 0;
  std::uint64_t seed_;
  std::uint64_t identity_ = 0;
  std::deque<std::uint64_t> own_;  // identities before it, the last ones

  State state_ = State::idle;
  std::string reason_;
  bool may_resume_ = true;   // what an earlier mission control has begun
  bool is_halting_ = false;  // stopped, and no mission since
  std::uint32_t waypoint_ = 0;
  std::vector<Arrival> arrivals_;
  std::uint32_t goals_sent_ = 0;
  std::uint32_t goals_for_waypoint_ = 0;
  std::optional<Time> started_;
  Time ended_{};
  Time waypoint_since_{};
  State state_before_pause_ = State::running;
  Time paused_since_{};
  bool is_held_ = false;  // the vehicle has named the goal of the pause or the stop

  std::optional<Time> first_heard_;
  std::optional<geometry::Pose> location_;
  GoalName told_;  // by the vehicle
  std::string status_;
  Time status_time_{};
  bool has_begun_ = false;  // a goal was sent, or taken on from an earlier mission control
  Time sent_{};
  Time leased_until_{};  // of the last waypoint's goal
  std::optional<Time> blocked_since_;
};

/// As MissionStatus.state has it.
constexpr std::array<const char*, 6> words_of(MissionControl::State) {
  return {"idle", "waiting", "running", "paused", "done", "aborted"};
}

}  // namespace tocsin
