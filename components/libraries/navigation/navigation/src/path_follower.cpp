// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_follower.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::navigation {
namespace {

/// The robot is looked for this far ahead on the path, so that it does not skip to a later
/// stretch that passes nearby.
constexpr double search_m = 1.0;
constexpr double turn_gain_per_s = 2.0;

double step_towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

PathFollower::PathFollower(const FollowerParams& params) : params_(params) {
  if (params.turn_done_rad >= params.turn_in_place_rad) {
    throw ConfigError("turn_done_rad: " + std::to_string(params.turn_done_rad) +
                      " is not below turn_in_place_rad (" +
                      std::to_string(params.turn_in_place_rad) + ")");
  }
}

void PathFollower::set_speeds(double speed_mps, double turn_rate_radps) {
  params_.speed_mps = speed_mps;
  params_.turn_rate_radps = turn_rate_radps;
}

void PathFollower::start(geometry::Path path) {
  assert(!path.empty());
  path_ = std::move(path);
  if (path_.size() == 1) path_.push_back(path_.front());
  to_end_m_.assign(path_.size(), 0);
  for (std::size_t i = path_.size() - 1; i > 0; --i) {
    to_end_m_[i - 1] = to_end_m_[i] + distance(path_[i - 1], path_[i]);
  }
  segment_ = 0;
  share_ = 0;
  turning_ = false;
}

geometry::Twist PathFollower::follow(const geometry::Pose& pose, Duration dt, double most_mps) {
  assert(!path_.empty());
  advance(position(pose));
  return limited(pursue(pose, most_mps), dt);
}

geometry::Twist PathFollower::turn_to(const geometry::Pose& pose, double yaw_rad, Duration dt) {
  return limited(turn(geometry::wrap_angle(yaw_rad - pose.heading_rad)), dt);
}

geometry::Twist PathFollower::move_at(const geometry::Twist& velocity, Duration dt) {
  return limited(velocity, dt);
}

geometry::Twist PathFollower::brake(Duration dt) { return limited({0, 0}, dt); }

geometry::Twist PathFollower::back_up(Duration dt) { return limited({-0.1, 0}, dt); }

geometry::Twist PathFollower::halt() { return velocity_ = {0, 0}; }

geometry::Path PathFollower::rest(const geometry::Point& from) const {
  geometry::Path rest{from};
  const std::size_t next = std::min(segment_ + 1, path_.size());
  rest.insert(rest.end(), path_.begin() + static_cast<std::ptrdiff_t>(next), path_.end());
  return rest;
}

void PathFollower::advance(const geometry::Point& p) {
  deviation_m_ = std::numeric_limits<double>::infinity();
  double ahead_m = -share_ * length_m(segment_);
  for (std::size_t i = segment_; i + 1 < path_.size() && ahead_m < search_m; ++i) {
    const double share = nearest_share(path_[i], path_[i + 1], p);
    const double away_m = distance(p, between(path_[i], path_[i + 1], share));
    if (away_m < deviation_m_) {
      deviation_m_ = away_m;
      segment_ = i;
      share_ = share;
    }
    ahead_m += length_m(i);
  }
  remaining_m_ = to_end_m_[segment_] - share_ * length_m(segment_);
}

geometry::Point PathFollower::point_ahead(double ahead_m) const {
  double share = share_;
  for (std::size_t i = segment_; i + 1 < path_.size(); ++i) {
    const double length = length_m(i);
    const double rest = (1 - share) * length;
    if (rest >= ahead_m && length > 0)
      return between(path_[i], path_[i + 1], share + ahead_m / length);
    ahead_m -= rest;
    share = 0;
  }
  return path_.back();
}

geometry::Twist PathFollower::pursue(const geometry::Pose& pose, double most_mps) {
  const geometry::Point target = point_ahead(params_.lookahead_m);
  const double error = geometry::wrap_angle(bearing(position(pose), target) - pose.heading_rad);
  turning_ = std::abs(error) > (turning_ ? params_.turn_done_rad : params_.turn_in_place_rad);
  if (turning_) return turn(error);
  const double target_m = std::max(distance(position(pose), target), 0.05);
  const double curvature = 2 * std::sin(error) / target_m;
  const double braking_mps = std::sqrt(2 * params_.acceleration_mps2 * remaining_m_);
  double v =
      std::min({params_.speed_mps, most_mps, std::max(params_.creep_mps, 0.9 * braking_mps)});
  v = std::min(v * std::cos(error), params_.turn_rate_radps / std::max(std::abs(curvature), 1e-9));
  return {v, v * curvature};
}

geometry::Twist PathFollower::turn(double error_rad) const {
  // Braking from the turn rate within the error keeps the heading from overshooting.
  const double rate = std::min({params_.turn_rate_radps, turn_gain_per_s * std::abs(error_rad),
                                std::sqrt(params_.turn_acceleration_radps2 * std::abs(error_rad))});
  return {0, std::copysign(rate, error_rad)};
}

geometry::Twist PathFollower::limited(const geometry::Twist& wanted, Duration dt) {
  const double dt_s = std::clamp(to_seconds(dt), 0.0, 0.2);
  velocity_.linear_mps =
      step_towards(velocity_.linear_mps, wanted.linear_mps, params_.acceleration_mps2 * dt_s);
  velocity_.angular_rad_s = step_towards(velocity_.angular_rad_s, wanted.angular_rad_s,
                                         params_.turn_acceleration_radps2 * dt_s);
  return velocity_;
}

}  // namespace tocsin::navigation
