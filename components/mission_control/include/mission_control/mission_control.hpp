// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "navigation/mission.hpp"

namespace tocsin {

/// A goal's id tells which waypoint of which mission it is, and grows with the wall clock, so that
/// a mission control that was started anew learns from the vehicle's status where it was.
struct GoalId {
  std::uint64_t issued_ms = 0;  // wall time; 42 bits reach to the year 2109
  std::uint32_t mission = 0;    // 10 bits, a checksum of the mission
  std::uint32_t waypoint = 0;   // 12 bits, from 0

  [[nodiscard]] std::uint64_t packed() const {
    return issued_ms << 22U | std::uint64_t{mission} << 12U | waypoint;
  }
  [[nodiscard]] static GoalId unpack(std::uint64_t id) {
    return {id >> 22U, static_cast<std::uint32_t>(id >> 12U & 0x3ffU),
            static_cast<std::uint32_t>(id & 0xfffU)};
  }
};

/// Leads the vehicle through a mission: sends waypoint after waypoint as goals, and judges arrival
/// by the reported location or by the navigator's own word, whichever comes first.
///
/// Pure: no clock, no I/O. `now` must not decrease between calls. A goal is a lease: it is renewed
/// while mission control lives, so that a vehicle out of reach stops when the lease is over, and
/// it is repeated until the vehicle's status names it and is not "held". It carries the waypoints
/// that follow, whose ids are its own plus 1, 2, ..., so that a vehicle that hears nothing drives
/// on; its status then names a later one. Silence never aborts a mission.
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

  enum class State { waiting, running, done, aborted };

  struct Goal {
    std::uint64_t id = 0;
    std::uint32_t waypoint = 0;
    navigation::Pose2 pose;
    double tolerance_m = 0;
    double lifetime_s = 0;
    std::vector<navigation::Pose2> ahead;
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

  /// Throws ConfigError when the mission has no waypoint, or the goal's lifetime is not longer
  /// than twice the repetition.
  MissionControl(const Params& params, navigation::Mission mission);

  /// Where the vehicle is, map frame; one that is not finite is ignored.
  void on_location(const navigation::Pose2& location, Time now);
  /// The vehicle's navigator says what it does: `state` as in NavigationStatus.
  void on_status(std::uint64_t goal_id, const std::string& state, Time now);

  /// The goal to send now, if any. To be called a few times a second. `wall_ms` is the wall time
  /// [ms since the Unix epoch].
  [[nodiscard]] std::optional<Goal> update(Time now, std::uint64_t wall_ms);

  [[nodiscard]] const navigation::Mission& mission() const { return mission_; }
  [[nodiscard]] Progress progress(Time now) const;
  /// All arrivals so far, in order.
  [[nodiscard]] const std::vector<Arrival>& arrivals() const { return arrivals_; }

 private:
  void start_when_ready(Time now);
  void resume_from(std::uint64_t goal_id);
  void check_arrival(Time now);
  [[nodiscard]] bool has_gone_on() const;
  void arrive(bool by_location, Time now);
  void check_limits(Time now);
  void finish(State state, std::string reason, Time now);
  [[nodiscard]] bool is_due(Time now) const;
  Goal issue(Time now, std::uint64_t wall_ms);
  [[nodiscard]] std::vector<navigation::Pose2> waypoints_ahead() const;
  [[nodiscard]] double distance_m() const;

  Params params_;
  navigation::Mission mission_;
  std::uint32_t checksum_;

  State state_ = State::waiting;
  std::string reason_;
  std::uint32_t waypoint_ = 0;
  std::vector<Arrival> arrivals_;
  std::uint32_t goals_sent_ = 0;
  std::uint32_t goals_for_waypoint_ = 0;
  std::optional<Time> started_;
  Time ended_{};
  Time waypoint_since_{};

  std::optional<Time> first_heard_;
  std::optional<navigation::Pose2> location_;
  std::uint64_t status_goal_ = 0;
  std::string status_;
  Time status_time_{};
  std::uint64_t newest_id_ = 0;           // ever seen, own or reported
  std::optional<std::uint64_t> goal_id_;  // of the present waypoint, once sent or told ahead
  Time sent_{};
  std::optional<Time> blocked_since_;
};

/// The word of MissionStatus.state.
[[nodiscard]] const char* to_string(MissionControl::State state);

}  // namespace tocsin
