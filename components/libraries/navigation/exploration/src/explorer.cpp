// SPDX-License-Identifier: Apache-2.0
#include "exploration/explorer.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::exploration {
namespace {

using geometry::Point;

constexpr double place_m = 0.5;  // side of a square that is listed
constexpr double least_way_m = 1.0;
constexpr double reach_m = 0.5;  // a blocked start is left for a cell within it, as by Planner
constexpr int most_failures = 2;
constexpr int most_arrivals = 2;
constexpr int most_choices = 8;
constexpr int most_waits = 10;
constexpr double tight_margin_m = 0.02;  // the navigator's, where it finds no other way
constexpr int least_looks = 3;           // one mistaken reading can close a door for a while

}  // namespace

Explorer::Place Explorer::place_of(const Point& p) {
  return {std::lround(std::floor(p.x_m / place_m)), std::lround(std::floor(p.y_m / place_m))};
}

bool Explorer::is_listed(const Point& p) const {
  const auto found = tallies_.find(place_of(p));
  return found != tallies_.end() && found->second.is_listed;
}

void Explorer::list(const Point& place, std::string reason) {
  tallies_[place_of(place)].is_listed = true;
  listed_.push_back({place, std::move(reason)});
}

double Explorer::score_of(const Frontier& frontier, double way_m) const {
  return std::min(frontier.length_m, params_.most_gain_m) / (way_m + least_way_m);
}

/// The cell nearest to the middle that is not listed.
std::optional<Explorer::Candidate> Explorer::candidate(
    const Frontier& frontier, const navigation::DistanceField& ways) const {
  if (frontier.length_m < params_.least_frontier_m) return std::nullopt;
  std::optional<Candidate> best;
  double best_m = infinity;
  for (const auto cell : frontier.cells) {
    const Point at = ways.grid().centre(cell);
    const double away_m = distance(at, frontier.middle);
    if (away_m >= best_m || is_listed(at)) continue;
    best_m = away_m;
    best = Candidate{at, score_of(frontier, ways.distance_m(at))};
  }
  return best;
}

double Explorer::present_score(const std::vector<Frontier>& frontiers,
                               const navigation::DistanceField& ways) const {
  if (!goal_) return 0;
  for (const Frontier& frontier : frontiers) {
    if (frontier.length_m < params_.least_frontier_m) continue;
    const bool is_there = std::any_of(
        frontier.cells.begin(), frontier.cells.end(),
        [&](navigation::CellIndex c) { return distance(ways.grid().centre(c), *goal_) < place_m; });
    const double way_m = ways.distance_m(*goal_);
    if (is_there && std::isfinite(way_m)) return score_of(frontier, way_m);
  }
  return 0;
}

Step Explorer::next(const navigation::OccupancyMap& map, const Point& robot) {
  navigation::InflationParams inflation = params_.inflation;
  const auto step = step_within(map, robot, inflation);
  if (step) return *step;
  // Noise of the map may close a door behind the robot.
  inflation.margin_m = std::min(inflation.margin_m, tight_margin_m);
  const auto tight = step_within(map, robot, inflation);
  if (tight) return *tight;
  const bool stands_free =
      is_finite(robot) && navigation::CostMap(map, inflation).nearest_free(robot, reach_m);
  return stands_free ? look_again() : wait();
}

/// Nothing: there is no frontier that can be reached with this inflation.
std::optional<Step> Explorer::step_within(const navigation::OccupancyMap& map, const Point& robot,
                                          const navigation::InflationParams& inflation) {
  const navigation::DistanceField ways(navigation::CostMap(map, inflation), robot);
  const auto frontiers = find_frontiers(map, ways);
  std::optional<Candidate> best;
  for (const Frontier& frontier : frontiers) {
    const auto other = candidate(frontier, ways);
    if (other && (!best || other->score > best->score)) best = other;
  }
  if (!best) return std::nullopt;
  waited_ = 0;
  looked_ = 0;
  const double present = present_score(frontiers, ways);
  if (present > 0 && best->score < params_.hysteresis * present) {
    return Step{Step::What::keep, *goal_, ""};
  }
  return choose(best->goal);
}

Step Explorer::choose(const Point& goal) {
  Tally& tally = tallies_[place_of(goal)];
  if (++tally.chosen >= most_choices) list(goal, "chosen eight times");
  goal_ = goal;
  return {Step::What::drive, goal, ""};
}

Step Explorer::wait() {
  const std::string reason = "the vehicle stands where nothing leads on";
  if (++waited_ < most_waits) return {Step::What::wait, {}, reason};
  goal_.reset();
  return {Step::What::done, {}, reason};
}

Step Explorer::look_again() {
  if (++looked_ < least_looks) return {Step::What::wait, {}, "it looks whether that was all"};
  return finish();
}

Step Explorer::finish() {
  goal_.reset();
  if (listed_.empty()) return {Step::What::done, {}, "all that can be reached is known"};
  return {Step::What::done,
          {},
          "all that can be reached is known, but for " + std::to_string(listed_.size()) +
              " places that were given up"};
}

void Explorer::on_reached() {
  if (!goal_) return;
  const Point goal = *goal_;
  goal_.reset();
  Tally& tally = tallies_[place_of(goal)];
  if (++tally.reached == most_arrivals && !tally.is_listed) {
    list(goal, "reached twice, and more is not seen from there");
  }
}

void Explorer::on_failed(const std::string& reason) {
  if (!goal_) return;
  const Point goal = *goal_;
  goal_.reset();
  Tally& tally = tallies_[place_of(goal)];
  if (++tally.failed == most_failures && !tally.is_listed) list(goal, reason);
}

}  // namespace tocsin::exploration
