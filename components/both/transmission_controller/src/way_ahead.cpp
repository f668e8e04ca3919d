// SPDX-License-Identifier: Apache-2.0
#include "transmission_controller/way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

using decision::Outlook;
using geometry::Point;

constexpr Duration place_serves = std::chrono::seconds(2);
constexpr Duration stands_after = std::chrono::seconds(3);
constexpr double moved_m = 0.2;
constexpr double beside_m = 1;

void add(Outlook& outlook, double risk) {
  outlook.risk_percent[outlook.size++] = static_cast<std::uint8_t>(std::lround(100 * risk));
}

}  // namespace

void WayAhead::set_plan(geometry::Path path) {
  const bool is_finite_path =
      std::all_of(path.begin(), path.end(), [](const Point& p) { return is_finite(p); });
  plan_ = is_finite_path ? std::move(path) : geometry::Path{};
}

void WayAhead::set_place(const Point& at, Time now) {
  if (!is_finite(at)) return;
  if (!place_ || distance(at, moved_from_) > moved_m) {
    moved_from_ = at;
    moved_ = now;
  }
  place_ = at;
  placed_ = now;
}

bool WayAhead::stands(Time now) const { return now - moved_ > stands_after; }

Outlook WayAhead::outlook(Time now) const {
  if (!risk_ || !place_ || now - placed_ > place_serves) return {};
  if (stands(now)) {
    Outlook outlook;
    while (outlook.size < Outlook::most) add(outlook, risk_->at(*place_));
    return outlook;
  }
  double least_m = beside_m;
  std::size_t corner = plan_.size();
  double share = 0;
  for (std::size_t i = 1; i < plan_.size(); ++i) {
    const double here = nearest_share(plan_[i - 1], plan_[i], *place_);
    const double away_m = distance(*place_, between(plan_[i - 1], plan_[i], here));
    if (away_m > least_m) continue;
    least_m = away_m;
    corner = i;
    share = here;
  }
  return corner == plan_.size() ? Outlook{} : along(corner, share);
}

/// From the share of the way to a corner on.
Outlook WayAhead::along(std::size_t corner, double share) const {
  Outlook outlook;
  Point at = between(plan_[corner - 1], plan_[corner], share);
  while (outlook.size < Outlook::most) {
    add(outlook, risk_->at(at));
    double left_m = speed_mps_;  // of this second
    while (left_m > 0 && corner < plan_.size()) {
      const double to_corner_m = distance(at, plan_[corner]);
      at = to_corner_m <= left_m ? plan_[corner] : between(at, plan_[corner], left_m / to_corner_m);
      if (to_corner_m <= left_m) ++corner;
      left_m -= to_corner_m;
    }
  }
  return outlook;
}

}  // namespace tocsin
