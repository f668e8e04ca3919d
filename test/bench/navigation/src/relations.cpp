// SPDX-License-Identifier: Apache-2.0
#include "relations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

namespace tocsin::bench {
namespace {

using geometry::Pose;
using Trajectory = std::map<double, Pose>;

Trajectory trajectory_of(const std::string& text) {
  Trajectory trajectory;
  std::istringstream lines(text);
  double time_s = 0;
  Pose pose;
  while (lines >> time_s >> pose.x_m >> pose.y_m >> pose.heading_rad) trajectory[time_s] = pose;
  return trajectory;
}

std::optional<Pose> pose_at(const Trajectory& trajectory, double time_s) {
  constexpr double same_s = 2e-4;
  const auto after = trajectory.lower_bound(time_s - same_s);
  if (after == trajectory.end()) return std::nullopt;
  if (after->first <= time_s + same_s) return after->second;
  if (after == trajectory.begin()) return std::nullopt;
  const auto& [t1, b] = *after;
  const auto& [t0, a] = *std::prev(after);
  const double u = (time_s - t0) / (t1 - t0);
  const double turn_rad = geometry::wrap_angle(b.heading_rad - a.heading_rad);
  return Pose{a.x_m + u * (b.x_m - a.x_m), a.y_m + u * (b.y_m - a.y_m),
              a.heading_rad + u * turn_rad};
}

}  // namespace

RelationErrors relation_errors(const std::string& trajectory, const std::string& relations,
                               bool loops_only) {
  const Trajectory poses = trajectory_of(trajectory);
  RelationErrors errors;
  double squares = 0;
  std::istringstream lines(relations);
  double t1 = 0;
  double t2 = 0;
  double skip = 0;
  Pose wanted;
  while (lines >> t1 >> t2 >> wanted.x_m >> wanted.y_m >> skip >> skip >> skip >>
         wanted.heading_rad) {
    const auto a = pose_at(poses, t1);
    const auto b = pose_at(poses, t2);
    if (!a || !b || (loops_only && std::abs(t2 - t1) < 30)) {
      ++errors.missing;
      continue;
    }
    const Pose off = relative(wanted, relative(*a, *b));
    const double off_m = std::hypot(off.x_m, off.y_m);
    ++errors.count;
    errors.mean_m += off_m;
    squares += off_m * off_m;
    errors.worst_m = std::max(errors.worst_m, off_m);
    errors.mean_deg += std::abs(off.heading_rad) / degree;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(1, errors.count));
  errors.mean_m /= n;
  errors.mean_deg /= n;
  errors.deviation_m = std::sqrt(std::max(0.0, squares / n - errors.mean_m * errors.mean_m));
  return errors;
}

}  // namespace tocsin::bench
