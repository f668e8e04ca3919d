// SPDX-License-Identifier: Apache-2.0
#include "mapping/spread_misfit.hpp"

#include <cassert>
#include <cmath>

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;
using geometry::wrap_angle;

std::vector<Pose> spread_misfit(const std::vector<Pose>& odometry, const Pose& first,
                                const Pose& last) {
  assert(odometry.size() >= 2);
  std::vector<Pose> steps;
  std::vector<double> ways{0};  // uncertainty from the first place on
  double turned_rad = 0;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Pose step = relative(odometry[i - 1], odometry[i]);
    ways.push_back(ways.back() + std::hypot(step.x_m, step.y_m) + std::abs(step.heading_rad));
    turned_rad += step.heading_rad;
    steps.push_back(step);
  }
  const auto share = [&](double way) { return ways.back() > 0 ? way / ways.back() : 0.0; };
  const double turn_misfit_rad = wrap_angle(last.heading_rad - first.heading_rad - turned_rad);
  std::vector<Pose> poses{first};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double half_rad = turn_misfit_rad * share(ways[i + 1] - ways[i]) / 2;
    // A step bends evenly: half of its correction is there in its middle.
    const Pose turned = compose({0, 0, half_rad}, compose(steps[i], {0, 0, half_rad}));
    poses.push_back(compose(poses.back(), turned));
  }
  const double off_x_m = last.x_m - poses.back().x_m;
  const double off_y_m = last.y_m - poses.back().y_m;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].x_m += share(ways[i]) * off_x_m;
    poses[i].y_m += share(ways[i]) * off_y_m;
  }
  poses.back() = last;
  return poses;
}

}  // namespace tocsin::mapping
