// SPDX-License-Identifier: Apache-2.0
#include "navigator/reconnection.hpp"

#include <algorithm>

#include "foundation/numbers.hpp"
#include "navigation/distance_field.hpp"

namespace tocsin {
namespace {

constexpr double beside_m = 2;    // shadowing is alike so far: a place that was tried in vain
constexpr double least_m = 0.75;  // nearer than this the link is lost
constexpr double miss_s = 20;     // of way and wait, where the link is not back at a place
constexpr double most_risk = 0.5;

}  // namespace

void Reconnection::end() {
  began_ = false;
  place_.reset();
  arrived_.reset();
  tried_.clear();
}

std::optional<geometry::Point> Reconnection::place(const navigation::CostMap& costs,
                                                   const navigation::LinkRisk& risk,
                                                   const geometry::Point& from,
                                                   const geometry::Point& goal, double speed_mps) {
  if (!began_) {
    began_ = true;
    left_m_ = params_.reconnect_within_m;
    tried_.push_back(from);
  }
  if (!place_ && left_m_ > 0) {
    const auto found = best(costs, risk, from, goal, speed_mps);
    left_m_ -= found ? found->way_m : left_m_;
    if (found) place_ = found->at;
  }
  return place_;
}

std::optional<Reconnection::Place> Reconnection::best(const navigation::CostMap& costs,
                                                      const navigation::LinkRisk& risk,
                                                      const geometry::Point& from,
                                                      const geometry::Point& goal,
                                                      double speed_mps) const {
  const navigation::DistanceField there(costs, from);
  const navigation::DistanceField onwards(costs, goal);
  std::optional<Place> best;
  double least_s = infinity;
  const navigation::Grid& grid = risk.grid();
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const geometry::Point at = grid.centre({column, row});
      const double way_m = there.distance_m(at);
      const double lost = risk.at(at);
      if (way_m > left_m_ || lost > most_risk || is_tried(at)) continue;
      const double after_s =
          (way_m + onwards.distance_m(at)) / speed_mps + lost * (params_.reconnect_wait_s + miss_s);
      if (after_s >= least_s) continue;
      least_s = after_s;
      best = Place{at, way_m};
    }
  }
  return best;
}

bool Reconnection::is_tried(const geometry::Point& at) const {
  const auto is_beside = [&](const geometry::Point& tried) {
    return distance(tried, at) < (&tried == &tried_.front() ? least_m : beside_m);
  };
  return std::any_of(tried_.begin(), tried_.end(), is_beside);
}

bool Reconnection::on_arrival(Time now) {
  if (!arrived_) arrived_ = now;
  if (now - *arrived_ < seconds(params_.reconnect_wait_s)) return false;
  give_up();
  return true;
}

void Reconnection::give_up() {
  if (place_) tried_.push_back(*place_);
  place_.reset();
  arrived_.reset();
}

}  // namespace tocsin
