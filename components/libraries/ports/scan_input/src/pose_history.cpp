// SPDX-License-Identifier: Apache-2.0
#include "scan_input/pose_history.hpp"

#include <algorithm>

namespace tocsin {
namespace {

constexpr std::int64_t kept_ns = 2'000'000'000;
constexpr std::int64_t newest_serves_ns = 200'000'000;

}  // namespace

void PoseHistory::add(std::int64_t stamp_ns, const geometry::Pose& pose) {
  if (!poses_.empty() && stamp_ns <= poses_.back().stamp_ns) poses_.clear();
  poses_.push_back({stamp_ns, pose});
  while (stamp_ns - poses_.front().stamp_ns > kept_ns) poses_.pop_front();
}

std::optional<geometry::Pose> PoseHistory::at(std::int64_t stamp_ns) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp_ns,
                       [](const Stamped& one, std::int64_t stamp) { return one.stamp_ns < stamp; });
  if (after == poses_.end()) {
    const bool serves = !poses_.empty() && stamp_ns - poses_.back().stamp_ns <= newest_serves_ns;
    return serves ? std::optional(poses_.back().pose) : std::nullopt;
  }
  if (after == poses_.begin()) {
    return after->stamp_ns == stamp_ns ? std::optional(after->pose) : std::nullopt;
  }
  const Stamped& a = *(after - 1);
  const Stamped& b = *after;
  const double share =
      static_cast<double>(stamp_ns - a.stamp_ns) / static_cast<double>(b.stamp_ns - a.stamp_ns);
  const geometry::Point at = between(position(a.pose), position(b.pose), share);
  const double turn_rad = geometry::wrap_angle(b.pose.heading_rad - a.pose.heading_rad);
  return geometry::Pose{at.x_m, at.y_m,
                        geometry::wrap_angle(a.pose.heading_rad + share * turn_rad)};
}

std::optional<geometry::Twist> PoseHistory::velocity(std::int64_t from_ns,
                                                     std::int64_t to_ns) const {
  constexpr std::int64_t least_ns = 20'000'000;
  const auto from = at(from_ns);
  const auto to = at(to_ns);
  if (!from || !to || to_ns - from_ns < least_ns) return std::nullopt;
  const double s = static_cast<double>(to_ns - from_ns) * 1e-9;
  const geometry::Pose step = relative(*from, *to);
  return geometry::Twist{step.x_m / s, step.heading_rad / s};
}

}  // namespace tocsin
