// SPDX-License-Identifier: Apache-2.0
#include "laser_model/laser_model.hpp"

#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

constexpr double edge_m = 0.1;  ///< what differs by more across a beam is an edge

bool is_in_view(const LaserProfile& profile, double bearing_rad) {
  if (profile.view_rad >= 2 * pi) return true;
  const double past_rad = bearing_rad - profile.first_rad;
  return past_rad - 2 * pi * std::floor(past_rad / (2 * pi)) <= profile.view_rad;
}

}  // namespace

double LaserModel::true_range(const Scene& scene, const geometry::Point& from, double bearing_rad) {
  const double most_m = profile_.max_range_m;
  const double range_m = scene.range(from, bearing_rad, most_m);
  if (profile_.beam_rad <= 0) return range_m;
  const double beside_m = scene.range(from, bearing_rad + profile_.beam_rad / 2, most_m);
  const bool is_edge =
      std::isfinite(range_m) && std::isfinite(beside_m) && std::abs(range_m - beside_m) > edge_m;
  if (!is_edge || uniform() >= profile_.mixed_share) return range_m;
  return range_m + uniform() * (beside_m - range_m);
}

double LaserModel::range(const Scene& scene, const geometry::Pose& laser, double bearing_rad) {
  if (!is_in_view(profile_, bearing_rad)) return nan;
  const double real_m =
      true_range(scene, geometry::position(laser), laser.heading_rad + bearing_rad);
  if (!std::isfinite(real_m) || uniform() < profile_.missing_share) return infinity;
  const double deviation_m = profile_.noise_m + profile_.noise_share * real_m +
                             profile_.noise_square_per_m * real_m * real_m;
  const double measured_m = real_m + deviation_m * normal_(random_);
  if (measured_m < profile_.min_range_m) return -infinity;
  return std::round(measured_m / profile_.step_m) * profile_.step_m;
}

std::vector<double> LaserModel::turn(const Scene& scene, std::size_t beams, double interval_s,
                                     const std::function<geometry::Pose(double)>& laser_at) {
  std::vector<double> ranges_m(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    const auto beam = static_cast<double>(i);
    const double bearing_rad = -pi + beam * 2 * pi / static_cast<double>(beams);
    ranges_m[i] = range(scene, laser_at(beam * interval_s), bearing_rad);
  }
  return ranges_m;
}

}  // namespace tocsin::laser
