// SPDX-License-Identifier: Apache-2.0
#include "mapping/mapper.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "mapping/relative_pose.hpp"

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;

Mapper::Mapper(const MapperParams& params) : params_(params), local_(params.local) {}

Pose Mapper::pose_at(const Pose& odometry) const {
  const Pose local = local_.pose_at(odometry);
  if (poses().empty()) return local;
  return compose(poses().back(), relative(nodes().back().pose, local));
}

bool Mapper::on_scan(const Pose& odometry, Scan scan) {
  const auto constraints = local_.on_scan(odometry, std::move(scan));
  if (!constraints) return false;
  const std::size_t node = nodes().size() - 1;
  graph_.add_node(
      node == 0 ? nodes().back().pose
                : compose(poses().back(), relative(nodes()[node - 1].pose, nodes()[node].pose)));
  for (const Constraint& constraint : *constraints) graph_.add(constraint);
  const auto ways = ways_from(node);
  match_near(node, ways);
  const bool closed = node % params_.loop_every == 0 && look_for_loops(node, ways);
  if (closed || node >= solved_at_ + params_.solve_every) {
    SolveParams solve;
    solve.graduated = closed;
    graph_.solve(solve);
    solved_at_ = node;
  }
  return true;
}

std::vector<double> Mapper::ways_from(std::size_t node) const {
  // Dijkstra; a recognised place joins its nodes by the straight way between them.
  std::vector<std::vector<std::pair<std::size_t, double>>> neighbours(poses().size());
  for (const Constraint& c : graph_.constraints()) {
    if (c.may_be_wrong && graph_.error_of(c) > SolveParams{}.doubted_error) continue;
    const double way_m = std::hypot(c.relative.x_m, c.relative.y_m);
    neighbours[c.from].emplace_back(c.to, way_m);
    neighbours[c.to].emplace_back(c.from, way_m);
  }
  std::vector<double> ways(poses().size(), infinity);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  ways[node] = 0;
  open.emplace(0, node);
  while (!open.empty()) {
    const auto [way_m, at] = open.top();
    open.pop();
    if (way_m > ways[at]) continue;
    for (const auto& [to, length_m] : neighbours[at]) {
      if (way_m + length_m >= ways[to]) continue;
      ways[to] = way_m + length_m;
      open.emplace(ways[to], to);
    }
  }
  return ways;
}

double Mapper::distance_to(const Submap& submap, std::size_t node) const {
  double nearest_m = infinity;
  for (const std::size_t other : submap.nodes()) {
    nearest_m =
        std::min(nearest_m, geometry::distance(position(poses()[other]), position(poses()[node])));
  }
  return nearest_m;
}

std::vector<std::size_t> Mapper::near_submaps(std::size_t node, const std::vector<double>& ways,
                                              std::size_t most) const {
  std::vector<std::pair<double, std::size_t>> near;
  const auto& submaps = local_.submaps();
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    const Submap& submap = submaps[i];
    const double way_m = ways[submap.first_node()];
    if (!submap.is_finished() || submap.contains(node) || way_m > 2 * params_.sure_way_m) continue;
    const double distance_m = distance_to(submap, node);
    if (distance_m <= params_.near_m) near.emplace_back(distance_m, i);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), most));
  std::vector<std::size_t> indices;
  for (const auto& [distance_m, index] : near) indices.push_back(index);
  return indices;
}

void Mapper::add_near(const Submap& submap, std::size_t node, const Pose& start) {
  const Points& points = nodes()[node].thin;
  const Match match = refine(submap.field(), points, start, start);
  if (match.score < params_.near_min_score) return;
  const Agreement agreement = submap.agreement(points, match.pose);
  if (agreement.seen < params_.loop.min_seen || agreement.opposed > params_.loop.max_opposed) {
    return;
  }
  graph_.add({submap.first_node(), node, match.pose, match.information, true});
}

void Mapper::match_near(std::size_t node, const std::vector<double>& ways) {
  SearchParams search_params;
  search_params.min_score = params_.near_min_score * 0.8;
  search_params.guess_weight = params_.local.guess_weight;
  for (const std::size_t index : near_submaps(node, ways, params_.most_near)) {
    const Submap& submap = local_.submaps()[index];
    const double way_m = ways[submap.first_node()];
    const SearchWindow window{params_.near_window_m + params_.drift_share * way_m, 0.1};
    const auto found =
        search(submap.bounds(), nodes()[node].thin,
               relative(poses()[submap.first_node()], poses()[node]), window, search_params);
    if (found) add_near(submap, node, found->pose);
  }
}

Points Mapper::recent_points(std::size_t node) const {
  Points points;
  const std::size_t first = node + 1 - std::min(node + 1, params_.loop_nodes);
  for (std::size_t i = first; i <= node; ++i) {
    const Points part =
        laser::transformed(nodes()[i].thin, relative(nodes()[node].pose, nodes()[i].pose));
    points.insert(points.end(), part.begin(), part.end());
  }
  return laser::thinned(points, params_.loop_thin_m);
}

bool Mapper::look_for_loops(std::size_t node, const std::vector<double>& ways) {
  bool closed = false;
  Points points;
  const auto& submaps = local_.submaps();
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    const Submap& submap = submaps[i];
    const double way_m = ways[submap.first_node()];
    if (!submap.is_finished() || way_m < 2 * params_.sure_way_m) continue;
    const double window_m = std::min(0.5 + params_.drift_share * way_m, params_.largest_window_m);
    if (distance_to(submap, node) > params_.loop_reach_m + window_m) continue;
    if (points.empty()) points = recent_points(node);
    const Pose guess = relative(poses()[submap.first_node()], poses()[node]);
    const double turn_rad = std::min(0.15 + 0.002 * way_m, 0.6);
    const auto match = find_loop(submap, points, guess, {window_m, turn_rad}, params_.loop);
    if (!match) continue;
    closed = accept({i, submap.first_node(), node, match->pose, match->information}) || closed;
  }
  return closed;
}

bool Mapper::accept(const LoopCandidate& candidate) {
  std::vector<Pose> local;
  local.reserve(nodes().size());
  for (const auto& node : nodes()) local.push_back(node.pose);
  const auto accepted = jury_.on_candidate(candidate, local);
  for (const LoopCandidate& loop : accepted) {
    graph_.add({loop.submap_node, loop.node, loop.relative, loop.information, true});
  }
  loops_ += accepted.size();
  return !accepted.empty();
}

void Mapper::match_all_again() {
  local_.rebuild(poses());
  std::vector<std::vector<std::size_t>> near;
  for (std::size_t node = 0; node < nodes().size(); ++node) {
    near.push_back(near_submaps(node, ways_from(node), params_.most_near_again));
  }
  graph_.drop_doubtful();
  for (std::size_t node = 0; node < nodes().size(); ++node) {
    for (const std::size_t index : near[node]) {
      const Submap& submap = local_.submaps()[index];
      add_near(submap, node, relative(poses()[submap.first_node()], poses()[node]));
    }
  }
  SolveParams solve;
  solve.graduated = false;
  graph_.solve(solve);
}

void Mapper::finish() {
  local_.finish();
  graph_.solve();
  for (int pass = 0; pass < params_.passes; ++pass) match_all_again();
}

navigation::OccupancyMap Mapper::map(double resolution_m) const {
  OccupancyGrid grid(resolution_m);
  for (std::size_t i = 0; i < nodes().size(); ++i) grid.insert(nodes()[i].scan, poses()[i]);
  return grid.map();
}

}  // namespace tocsin::mapping
