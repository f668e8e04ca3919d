// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "geometry/pose.hpp"
#include "laser_model/laser_profile.hpp"
#include "laser_model/scene.hpp"

namespace tocsin::laser {

/// What a laser measures of a scene. Seeded: the same calls give the same readings. Pure.
class LaserModel {
 public:
  LaserModel(const LaserProfile& profile, std::uint64_t seed) : profile_(profile), random_(seed) {}

  /// The reading of one beam of a laser at `laser` (map frame), `bearing_rad` counter-clockwise
  /// from its ahead [m]. +inf: no return; NaN: out of its view; -inf: nearer than it can measure
  /// (REP 117).
  [[nodiscard]] double range(const Scene& scene, const geometry::Pose& laser, double bearing_rad);

  /// One turn of `beams` readings, counter-clockwise from behind, `interval_s` apart; where the
  /// laser is at a time since the first one [s] is `laser_at`.
  [[nodiscard]] std::vector<double> turn(const Scene& scene, std::size_t beams, double interval_s,
                                         const std::function<geometry::Pose(double)>& laser_at);

  [[nodiscard]] const LaserProfile& profile() const { return profile_; }

 private:
  /// Of a beam that may be half on an edge.
  [[nodiscard]] double true_range(const Scene& scene, const geometry::Point& from,
                                  double bearing_rad);
  [[nodiscard]] double uniform() { return std::uniform_real_distribution<>()(random_); }

  LaserProfile profile_;
  std::mt19937_64 random_;
  std::normal_distribution<> normal_;
};

}  // namespace tocsin::laser
