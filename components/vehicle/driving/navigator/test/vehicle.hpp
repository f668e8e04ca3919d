// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "foundation/numbers.hpp"

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"
#include "navigator/navigator.hpp"

namespace tocsin {

using navigation::Cell;
using navigation::Grid;
using navigation::OccupancyMap;
using State = Navigator::State;
using Answer = GoalAnswer;

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration period = std::chrono::milliseconds(50);

/// 8 m x 4 m; a wall at x = 4 from y = 0 to `wall_m`.
inline OccupancyMap floor_with_wall(double wall_m) {
  const Grid grid{160, 80, 0.05, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int row = 0; row < static_cast<int>(wall_m / 0.05); ++row) {
    cells[grid.offset({80, row})] = Cell::occupied;
  }
  return {grid, cells};
}

/// A navigator in a vehicle that does what it is told, at once unless it lags, never when jammed.
class Vehicle {
 public:
  explicit Vehicle(const Navigator::Params& params = {}, double wall_m = 2.0)
      : map(floor_with_wall(wall_m)), sut(params, map) {}

  /// One control period.
  Navigator::Output step() {
    now += period;
    if (has_localisation) sut.on_pose(pose, now);
    const auto output = sut.update(now);
    driven.linear_mps += (1 - lag) * (output.velocity.linear_mps - driven.linear_mps);
    driven.angular_rad_s += (1 - lag) * (output.velocity.angular_rad_s - driven.angular_rad_s);
    if (!is_jammed)
      pose = compose(pose, {driven.linear_mps * 0.05, 0, driven.angular_rad_s * 0.05});
    return output;
  }
  Navigator::Output run(double s) {
    Navigator::Output output;
    for (int i = 0; i < std::lround(s / 0.05); ++i) output = step();
    return output;
  }
  Answer send(std::uint64_t id, const geometry::Pose& to, double lifetime_s = 1000) {
    return sut.on_goal({mission, id, {to}, 0.15, now + seconds(lifetime_s), {}}, now);
  }
  Answer send_list(std::uint64_t id, const std::vector<geometry::Pose>& poses,
                   double lifetime_s = 1000) {
    Goal goal{mission, id, {poses.front()}, 0.15, now + seconds(lifetime_s), {}};
    for (std::size_t i = 1; i < poses.size(); ++i) goal.ahead.push_back({poses[i]});
    return sut.on_goal(goal, now);
  }
  double distance_to(const geometry::Pose& to) const {
    return distance(position(pose), position(to));
  }

  OccupancyMap map;
  Navigator sut;
  Time now = t0;
  std::uint64_t mission = 7;  // of the goals it is sent
  geometry::Pose pose{1, 1, 0};
  bool has_localisation = true;
  bool is_jammed = false;
  double lag = 0;  // share of the old velocity that is left after a period
  geometry::Twist driven;
};

inline Navigator::Params on_link_lost(OnLinkLost what) {
  Navigator::Params params;
  params.on_link_lost = what;
  params.link_lost_after_s = 10;
  return params;
}

}  // namespace tocsin
