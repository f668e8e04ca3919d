// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/time.hpp"
#include "kobuki_protocol/feedback.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::motion {

using kobuki::BodyVelocity;

/// What endangers the base: bumper, cliff and wheel-drop bits of core sensors.
struct Hazards {
  std::uint8_t bumper = 0;
  std::uint8_t cliff = 0;
  std::uint8_t wheel_drop = 0;
};

/// Takes the base away from obstacles and cliffs, or only keeps it from going on.
///
/// `back_off` gives a velocity of its own while a hazard lasts, in the order of the ROS
/// counterpart: wheel drop, centre, left, right (reference page 1.12). `stop_only` moves nothing by
/// itself and filters the others' velocities. Pure; `now` must not decrease.
class SafetyController {
 public:
  struct Params {
    bool stop_only = false;
    double time_to_extend_s = 0;
    double back_off_mps = 0.1;
    double turn_rad_s = 0.4;
    double silence_s = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("stop_only", stop_only, "only stops, never moves backwards by itself");
      v("time_to_extend_s", time_to_extend_s, {0, 10}, "[s] a hazard lasts so much longer");
      v("back_off_mps", back_off_mps, {0, 0.5}, "[m/s] away from a bump or cliff");
      v("turn_rad_s", turn_rad_s, {0, 2}, "[rad/s] away from a bump or cliff at a side");
      v("silence_s", silence_s, {0.05, 10}, "[s] without sensors no back-off continues");
    }
  };

  explicit SafetyController(const Params& params) : params_(params) {}
  void on_sensors(const Hazards& hazards, Time now);
  void set_enabled(bool enabled) { enabled_ = enabled; }

  /// The velocity that overrides all others; empty when there is no reason, and always in stop_only
  /// except for a wheel drop.
  [[nodiscard]] std::optional<BodyVelocity> override_velocity(Time now) const;
  /// What is left of a wanted velocity: no forward motion into a bump or cliff, none at all with a
  /// dropped wheel. Backwards and turning stay possible.
  [[nodiscard]] BodyVelocity filter(const BodyVelocity& wanted, Time now) const;

 private:
  [[nodiscard]] Hazards present(Time now) const;
  Params params_;
  bool enabled_ = true;
  Hazards now_;
  Hazards extended_;
  Time last_hazard_ = Time::min();
  Time last_sensors_ = Time::min();
};

}  // namespace tocsin::motion
