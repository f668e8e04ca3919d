// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin {

/// What endangers the base: bumper, cliff and wheel-drop bits of core sensors.
struct Hazards {
  std::uint8_t bumper = 0;
  std::uint8_t cliff = 0;
  std::uint8_t wheel_drop = 0;
};

/// The last that a velocity passes before the base: keeps it from an obstacle or cliff, or takes it
/// away from there, and keeps it standing while the emergency stop is pressed.
///
/// `back_off` gives a velocity of its own while a hazard lasts, in the order of the ROS
/// counterpart: wheel drop, centre, left, right (reference page 1.12). `stop_only` moves nothing by
/// itself and filters what is wanted. An event only ever slows the base down; what makes it faster
/// is a new wanted velocity. Pure; `now` must not decrease.
class SafetyController {
 public:
  struct Params {
    bool stop_only = false;
    double time_to_extend_s = 0;
    double back_off_mps = 0.1;
    double turn_rad_s = 0.4;
    double back_off_s = 2;
    template <class Visitor>
    void visit(Visitor& v) {
      v("stop_only", stop_only, "only stops, never moves backwards by itself");
      v("time_to_extend_s", time_to_extend_s, {0, 10}, "[s] a hazard lasts so much longer");
      v("back_off_mps", back_off_mps, {0, 0.5}, "[m/s] away from a bump or cliff");
      v("turn_rad_s", turn_rad_s, {0, 2}, "[rad/s] away from a bump or cliff at a side");
      v("back_off_s", back_off_s, {0.05, 60},
        "[s] away from one hazard; when it lasts longer, only forward motion is stopped");
    }
  };

  explicit SafetyController(const Params& params) : params_(params) {}
  void on_hazards(const Hazards& hazards, Time now);
  void on_emergency_stop(bool pressed) { stopped_ = pressed; }
  /// False: neither bumper nor cliff nor wheel drop count. The emergency stop always does.
  void set_enabled(bool enabled) { enabled_ = enabled; }

  /// What is left of a wanted velocity: the velocity to send. NaN or infinity is a stop.
  [[nodiscard]] geometry::Twist on_wanted(const geometry::Twist& wanted, Time now);
  /// The velocity to send without a new wish, if any; call after events and at `next_deadline`.
  [[nodiscard]] std::optional<geometry::Twist> update(Time now);
  [[nodiscard]] Time next_deadline(Time now) const;

  [[nodiscard]] const Hazards& hazards() const { return now_; }
  [[nodiscard]] bool emergency_stop() const { return stopped_; }
  [[nodiscard]] bool enabled() const { return enabled_; }

 private:
  static constexpr Duration repeat = std::chrono::milliseconds(100);
  [[nodiscard]] Hazards present(Time now) const;
  /// The velocity that replaces all others; empty when there is no reason.
  [[nodiscard]] std::optional<geometry::Twist> override_velocity(Time now) const;
  [[nodiscard]] geometry::Twist filter(const geometry::Twist& wanted, Time now) const;
  geometry::Twist send(const geometry::Twist& velocity, Time now);

  Params params_;
  bool enabled_ = true;
  bool stopped_ = false;
  Hazards now_;
  Hazards extended_;
  Time last_hazard_ = Time::min();   ///< when one was last known to be there
  Time hazard_since_ = Time::min();  ///< since when there is one without a pause
  geometry::Twist sent_;
  bool overriding_ = false;
  Time next_repeat_ = Time::min();
};

}  // namespace tocsin
