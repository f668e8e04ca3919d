// SPDX-License-Identifier: Apache-2.0
#include "collision_brake/collision_brake.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using geometry::Point;
using geometry::Twist;

constexpr double looked_at_m = 3.0;        // farther away nothing limits the speed
constexpr double fastest_other_mps = 2.5;  // what seems faster is something else
constexpr double straight_per_m = 1e-3;
constexpr double stuck_after_s = 1.0;
constexpr double walkers_within_m = 2.0;
constexpr double entered_m = 0.08;  // so much nearer than where a beam ended something has come
constexpr double companion_m = 0.15;
constexpr Duration walkers_last = std::chrono::milliseconds(600);
constexpr double moves_mps = 0.05;
constexpr double beside = 0.5;    // cosine of the bearing from which on it is not ahead
constexpr double touch_m = 0.01;  // nearer to the body is a touch

bool is_finite(const Twist& v) {
  return std::isfinite(v.linear_mps) && std::isfinite(v.angular_rad_s);
}

Point in_frame_of(const geometry::Pose& pose, const Point& p) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  const double dx = p.x_m - pose.x_m;
  const double dy = p.y_m - pose.y_m;
  return {c * dx + s * dy, c * dy - s * dx};
}

/// How far a disc of radius `reach_m` drives ahead, on a circle that bends to the left by
/// `bend_per_m`, until it touches a point outside of it. Infinity: it never does.
double way_until(const Point& p, double bend_per_m, double reach_m) {
  if (std::abs(bend_per_m) < straight_per_m) {
    const double beside_m = std::abs(p.y_m);
    if (p.x_m <= 0 || beside_m >= reach_m) return infinity;
    return p.x_m - std::sqrt(reach_m * reach_m - beside_m * beside_m);
  }
  const double radius_m = 1 / std::abs(bend_per_m);
  const double y_m = bend_per_m > 0 ? p.y_m : -p.y_m;  // as if it bent to the left
  const double away_m = std::hypot(p.x_m, radius_m - y_m);
  if (std::abs(away_m - radius_m) >= reach_m || away_m == 0) return infinity;
  double to_point_rad = std::atan2(p.x_m, radius_m - y_m);
  if (to_point_rad < 0) to_point_rad += 2 * pi;
  const double cosine =
      (radius_m * radius_m + away_m * away_m - reach_m * reach_m) / (2 * radius_m * away_m);
  const double touching_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
  return radius_m * std::max(0.0, to_point_rad - touching_rad);
}

std::size_t degree_of(const Point& from, const Point& to) {
  const double share = geometry::bearing(from, to) / (2 * pi) + 0.5;
  return std::min<std::size_t>(359, static_cast<std::size_t>(share * 360));
}

/// From a place to the nearest point of the next metres of an arc that begins at the origin.
double gap_to_arc_m(const Point& p, const Twist& arc, double length_m) {
  constexpr int samples = 30;
  const double way_m = arc.linear_mps > 0 ? length_m : -length_m;
  const double turn_rad = arc.angular_rad_s / arc.linear_mps * way_m;
  double nearest_m = infinity;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const double bend_rad = share * turn_rad;
    const double chord_m = std::abs(bend_rad) < 1e-6
                               ? share * way_m
                               : share * way_m * std::sin(bend_rad / 2) / (bend_rad / 2);
    const Point at{chord_m * std::cos(bend_rad / 2), chord_m * std::sin(bend_rad / 2)};
    nearest_m = std::min(nearest_m, geometry::distance(at, p));
  }
  return nearest_m;
}

}  // namespace

void CollisionBrake::on_pose(const geometry::Pose& pose, const Twist& velocity, Time now) {
  if (!geometry::is_finite(pose) || !is_finite(velocity)) return;
  pose_ = pose;
  velocity_ = velocity;
  pose_time_ = now;
}

void CollisionBrake::on_scan(const laser::Scan& scan, const geometry::Pose& pose, Time now) {
  if (!geometry::is_finite(pose)) return;
  const bool is_same = last_scan_ && laser::is_repeated(*last_scan_, scan);
  const bool may_be_same = !is_same || std::abs(velocity_.linear_mps) < moves_mps;
  if (may_be_same) same_since_.reset();
  if (!may_be_same && !same_since_) same_since_ = now;
  last_scan_ = scan;
  find_walkers(scan, pose, now);
  before_ = std::move(points_);
  period_s_ = scan_time_ ? to_seconds(now - *scan_time_) : 0;
  points_.clear();
  for (const Point& hit : scan.hits) {
    if (std::hypot(hit.x_m, hit.y_m) <= looked_at_m) points_.push_back(hit);
  }
  points_ = laser::transformed(points_, pose);
  scan_pose_ = pose;
  scan_time_ = now;
  look_for_sectors(scan);
}

void CollisionBrake::look_for_sectors(const laser::Scan& scan) {
  Sectors has_beam{};
  Sectors has_return{};
  const auto note = [](Sectors& in, const Point& p) {
    const double share = std::atan2(p.y_m, p.x_m) / (2 * pi) + 0.5;
    in[std::min(sectors - 1, static_cast<std::size_t>(share * sectors))] = true;
  };
  for (const Point& hit : scan.hits) {
    note(has_beam, hit);
    note(has_return, hit);
  }
  for (const Point& end : scan.misses) note(has_beam, end);
  is_seen_ = has_beam;
  find_covered(has_return);
  had_return_ = has_return;
  for (std::size_t i = 0; i < sectors; ++i) is_seen_[i] = is_seen_[i] && !is_covered_[i];
}

/// Open floor loses its returns one after the other; what is hung over the laser takes them at
/// once. A sector that has a return again is not covered.
void CollisionBrake::find_covered(const Sectors& has_return) {
  const double least = params_.covered_sector_deg * sectors / 360;
  for (std::size_t i = 0; i < sectors; ++i) is_covered_[i] = is_covered_[i] && !has_return[i];
  std::size_t lost = 0;  // in a row up to here, twice round so that the seam does not matter
  for (std::size_t i = 0; i < 2 * sectors; ++i) {
    const std::size_t at = i % sectors;
    lost = had_return_[at] && !has_return[at] ? lost + 1 : 0;
    if (static_cast<double>(lost) < least) continue;
    for (std::size_t k = 0; k < std::min(lost, sectors); ++k) {
      is_covered_[(i + sectors - k) % sectors] = true;
    }
  }
}

/// Where the last turn looked through and now something is, something walks. What was hidden then
/// tells nothing. A single reading may be half of one thing and half of another.
void CollisionBrake::find_walkers(const laser::Scan& scan, const geometry::Pose& pose, Time now) {
  const auto is_old = [now](const Walker& one) { return now - one.seen > walkers_last; };
  walkers_.erase(std::remove_if(walkers_.begin(), walkers_.end(), is_old), walkers_.end());
  laser::Points entered;
  for (const Point& hit : scan.hits) {
    if (std::hypot(hit.x_m, hit.y_m) > walkers_within_m) continue;
    const Point at = laser::transformed({hit}, pose).front();
    const Point seen = in_frame_of(scan_pose_, at);
    const double free_m = reach_[degree_of(scan_laser_, seen)];
    if (free_m > geometry::distance(scan_laser_, seen) + entered_m) entered.push_back(at);
  }
  for (const Point& one : entered) {
    const auto is_beside = [&one](const Point& other) {
      return &other != &one && geometry::distance(one, other) < companion_m;
    };
    const bool is_alone = std::none_of(entered.begin(), entered.end(), is_beside);
    if (!is_alone && params_.walking_mps > 0) walkers_.push_back({one, now});
  }
  note_reach(scan);
}

/// How far each degree and its neighbours looked through; 0 where one of them has no beam.
void CollisionBrake::note_reach(const laser::Scan& scan) {
  scan_laser_ = scan.laser;
  std::array<double, degrees> nearest{};
  const auto note = [&](const Point& end) {
    double& range_m = nearest[degree_of(scan.laser, end)];
    const double end_m = geometry::distance(scan.laser, end);
    range_m = range_m == 0 ? end_m : std::min(range_m, end_m);
  };
  for (const Point& hit : scan.hits) note(hit);
  for (const Point& end : scan.misses) note(end);
  for (std::size_t i = 0; i < degrees; ++i) {
    reach_[i] =
        std::min({nearest[(i + degrees - 1) % degrees], nearest[i], nearest[(i + 1) % degrees]});
  }
}

/// So slow that it stands before whoever walks can be in its way: the time to stop is at most that
/// of a walk to the nearest place of the arc.
double CollisionBrake::allowed_by_walkers_mps(const Twist& arc) const {
  const double a = params_.deceleration_mps2;
  const double longest_m = looked_at_m;
  double most_mps = infinity;
  for (const Walker& walker : walkers_) {
    const Point p = in_frame_of(pose_, walker.at);
    const double gap_m = gap_to_arc_m(p, arc, longest_m) - params_.body_radius_m - params_.margin_m;
    const double time_s = std::max(0.0, gap_m) / params_.walking_mps - params_.dead_time_s;
    most_mps = std::min(most_mps, a * std::max(0.0, time_s));
  }
  return most_mps;
}

void CollisionBrake::on_bypass(bool wanted, Time now) {
  bypassed_until_ = wanted ? now + seconds(params_.bypass_s) : Time::min();
}

CollisionBrake::Verdict CollisionBrake::check(const Twist& wanted, Time now) const {
  if (!is_finite(wanted)) return {{}, Action::stop, "no_number"};
  if (is_bypassed(now)) return {wanted, Action::none, "bypass"};
  if (wanted.linear_mps == 0) return {wanted, Action::none, ""};
  if (const char* reason = reason_of_blindness(now)) return without_sight(wanted, reason);
  if (!sees_towards(wanted.linear_mps > 0 ? 0 : pi)) return without_sight(wanted, "blind");
  double most_mps = std::min(allowed_mps(wanted), allowed_by_walkers_mps(wanted));
  const bool goes_on =
      velocity_.linear_mps * wanted.linear_mps > 0 && std::abs(velocity_.linear_mps) > moves_mps;
  if (goes_on) most_mps = std::min(most_mps, allowed_mps(velocity_));
  const double speed_mps = std::abs(wanted.linear_mps);
  if (most_mps >= speed_mps) return {wanted, Action::none, ""};
  if (most_mps <= 0) return {{0, wanted.angular_rad_s}, Action::stop, "obstacle"};
  const double share = most_mps / speed_mps;  // the arc stays
  return {{wanted.linear_mps * share, wanted.angular_rad_s * share}, Action::approach, "obstacle"};
}

/// Null: it sees.
const char* CollisionBrake::reason_of_blindness(Time now) const {
  const Duration timeout = seconds(params_.scan_timeout_s);
  if (!scan_time_ || now - *scan_time_ > timeout) return "no_scan";
  if (!pose_time_ || now - *pose_time_ > timeout) return "no_odometry";
  if (same_since_ && now - *same_since_ > seconds(stuck_after_s)) return "stuck_scan";
  return nullptr;
}

/// Turning goes on at its rate.
CollisionBrake::Verdict CollisionBrake::without_sight(const Twist& wanted,
                                                      const char* reason) const {
  if (params_.without_scan == WithoutScan::pass) return {wanted, Action::none, reason};
  if (params_.without_scan == WithoutScan::stop) {
    return {{0, wanted.angular_rad_s}, Action::stop, reason};
  }
  const double most_mps = params_.crawl_mps;
  if (std::abs(wanted.linear_mps) <= most_mps) return {wanted, Action::none, reason};
  const double share = most_mps / std::abs(wanted.linear_mps);
  return {{wanted.linear_mps * share, wanted.angular_rad_s * share}, Action::limit, reason};
}

/// Whether all of 20 degrees to both sides was looked at.
bool CollisionBrake::sees_towards(double bearing_rad) const {
  const double at_scan_rad = bearing_rad + pose_.heading_rad - scan_pose_.heading_rad;
  for (int step = -4; step <= 4; ++step) {
    const double towards_rad = geometry::wrap_angle(at_scan_rad + step * 5 * degree);
    const double share = towards_rad / (2 * pi) + 0.5;
    if (!is_seen_[std::min(sectors - 1, static_cast<std::size_t>(share * sectors))]) return false;
  }
  return true;
}

double CollisionBrake::allowed_mps(const Twist& arc) const {
  const double free_m = free_way_m(points_, arc);
  if (free_m == infinity) return infinity;
  double nearing_mps = 0;
  const double before_m = free_way_m(before_, arc);
  if (period_s_ > 0 && before_m != infinity && before_m > free_m) {
    nearing_mps = (before_m - free_m) / period_s_;
    if (nearing_mps > fastest_other_mps) nearing_mps = 0;
  }
  const double a = params_.deceleration_mps2;
  const double t = params_.dead_time_s;
  const double lag_s = t + nearing_mps / a;
  const double rest_m = free_m - nearing_mps * t;
  if (rest_m <= 0) return 0;
  return a * (std::sqrt(lag_s * lag_s + 2 * rest_m / a) - lag_s);
}

/// What stands within the margin already may be passed when it is beside, but not be brought into
/// the body.
double CollisionBrake::free_way_m(const laser::Points& points, const Twist& arc) const {
  const double reach_m = params_.body_radius_m + params_.margin_m;
  const double least_m = params_.body_radius_m + std::min(params_.margin_m, touch_m);
  const double ahead = arc.linear_mps > 0 ? 1 : -1;
  const double bend_per_m = arc.angular_rad_s / arc.linear_mps;  // the same seen backwards
  double free_m = infinity;
  for (const Point& point : points) {
    Point p = in_frame_of(pose_, point);
    p.x_m *= ahead;
    const double away_m = std::hypot(p.x_m, p.y_m);
    if (away_m > reach_m) {
      free_m = std::min(free_m, way_until(p, bend_per_m, reach_m));
    } else if (p.x_m > beside * away_m || (away_m <= least_m && p.x_m > 0)) {
      return 0;
    } else if (away_m > least_m) {
      free_m = std::min(free_m, way_until(p, bend_per_m, least_m));
    }
  }
  return free_m;
}

}  // namespace tocsin
