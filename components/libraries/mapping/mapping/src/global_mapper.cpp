// SPDX-License-Identifier: Apache-2.0
#include "mapping/global_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;

GlobalMapper::GlobalMapper(const MapperParams& params) : params_(params) {}

GlobalMapper::GlobalMapper(const MapperParams& params, MapSession session) : params_(params) {
  for (MapSession::Node& node : session.nodes) {
    graph_.add_node(node.pose);
    nodes_.push_back({node.pose, node.pose, std::move(node.scan), true});
  }
  for (const Constraint& constraint : session.constraints) graph_.add(constraint);
  for (const auto& nodes : session.submaps) {
    submaps_.emplace_back(nodes.front(), params_.local.resolution_m, params_.local.sigma_m);
    for (const std::size_t node : nodes) {
      submaps_.back().insert(node, nodes_[node].scan.unpacked(),
                             relative(poses()[nodes.front()], poses()[node]));
    }
    submaps_.back().finish();
  }
  solved_at_ = nodes_.size();
}

MapSession GlobalMapper::session() const {
  MapSession session;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    session.nodes.push_back({poses()[i], nodes_[i].scan});
  }
  for (const Submap& submap : submaps_) session.submaps.push_back(submap.nodes());
  session.constraints = graph_.constraints();
  return session;
}

void GlobalMapper::add(LocalStep step) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({step.odometry, step.pose, PackedScan(step.scan), step.matched});
  const bool is_first = step.constraints.empty();
  graph_.add_node(
      is_first ? step.pose
               : compose(poses().back(), relative(nodes_[node - 1].pose, nodes_[node].pose)));
  for (const Constraint& constraint : step.constraints) graph_.add(constraint);
  if (is_first && node > 0) graph_.add(anchor_of(node));
  for (Submap& submap : step.finished) submaps_.push_back(std::move(submap));
  const auto ways = ways_from(node);
  match_near(node, ways);
  const bool closed = node % params_.loop_every == 0 && look_for_loops(node, ways);
  if (closed || node >= solved_at_ + params_.solve_every) {
    SolveParams solve;
    solve.graduated = closed;
    graph_.solve(solve);
    solved_at_ = node;
  }
}

/// A session goes on: ties the first node of this run to the nearest one of those before, loosely.
Constraint GlobalMapper::anchor_of(std::size_t node) const {
  const auto away_m = [&](std::size_t other) {
    return geometry::distance(position(poses()[other]), position(poses()[node]));
  };
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < node; ++i) {
    if (away_m(i) < away_m(nearest)) nearest = i;
  }
  constexpr double loose_m = 0.2;
  constexpr double loose_rad = 0.1;
  const Eigen::Vector3d deviations(loose_m, loose_m, loose_rad);
  return {nearest, node, relative(poses()[nearest], poses()[node]),
          deviations.cwiseAbs2().cwiseInverse().asDiagonal(), true};
}

const Submap& GlobalMapper::awake(std::size_t index) const {
  awake_.erase(std::remove(awake_.begin(), awake_.end(), index), awake_.end());
  awake_.push_back(index);
  if (awake_.size() > params_.most_awake) {
    submaps_[awake_.front()].rest();
    awake_.pop_front();
  }
  return submaps_[index];
}

std::vector<double> GlobalMapper::ways_from(std::size_t node) const {
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

double GlobalMapper::distance_to(const Submap& submap, const Pose& pose) const {
  double nearest_m = infinity;
  for (const std::size_t other : submap.nodes()) {
    nearest_m = std::min(nearest_m, geometry::distance(position(poses()[other]), position(pose)));
  }
  return nearest_m;
}

Points GlobalMapper::thin(std::size_t node) const {
  return laser::thinned(nodes_[node].scan.hits(), params_.local.thin_m);
}

std::vector<std::size_t> GlobalMapper::near_submaps(std::size_t node,
                                                    const std::vector<double>& ways,
                                                    std::size_t most) const {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < submaps_.size(); ++i) {
    const Submap& submap = submaps_[i];
    const double way_m = ways[submap.first_node()];
    if (submap.contains(node) || way_m > 2 * params_.sure_way_m) continue;
    const double distance_m = distance_to(submap, poses()[node]);
    if (distance_m <= params_.near_m) near.emplace_back(distance_m, i);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), most));
  std::vector<std::size_t> indices;
  for (const auto& [distance_m, index] : near) indices.push_back(index);
  return indices;
}

void GlobalMapper::add_near(const Submap& submap, std::size_t node, const Points& points,
                            const Match& match) {
  if (match.score < params_.near_min_score) return;
  const Agreement agreement = submap.agreement(points, match.pose);
  if (agreement.seen < params_.loop.min_seen || agreement.opposed > params_.loop.max_opposed) {
    return;
  }
  graph_.add({submap.first_node(), node, match.pose, match.information, true});
}

void GlobalMapper::match_near(std::size_t node, const std::vector<double>& ways) {
  SearchParams search_params;
  search_params.min_score = params_.near_min_score * 0.8;
  search_params.guess_weight = params_.local.guess_weight;
  const Points points = thin(node);
  for (const std::size_t index : near_submaps(node, ways, params_.most_near)) {
    const Submap& submap = awake(index);
    const double way_m = ways[submap.first_node()];
    const Pose guess = relative(poses()[submap.first_node()], poses()[node]);
    Match match = refine(submap.field(), points, guess, guess);
    if (!is_sure(match, guess, submap.field(), params_.local.sure_score)) {
      const SearchWindow window{params_.near_window_m + params_.drift_share * way_m, 0.1};
      const auto found = search(submap.bounds(), points, guess, window, search_params);
      if (!found) continue;
      match = refine(submap.field(), points, found->pose, found->pose);
    }
    add_near(submap, node, points, match);
  }
}

Points GlobalMapper::recent_points(std::size_t node) const {
  Points points;
  const std::size_t first = node + 1 - std::min(node + 1, params_.loop_nodes);
  for (std::size_t i = first; i <= node; ++i) {
    const Points part = laser::transformed(thin(i), relative(nodes()[node].pose, nodes()[i].pose));
    points.insert(points.end(), part.begin(), part.end());
  }
  return laser::thinned(points, params_.loop_thin_m);
}

bool GlobalMapper::look_for_loops(std::size_t node, const std::vector<double>& ways) {
  bool closed = false;
  Points points;
  for (std::size_t i = 0; i < submaps_.size(); ++i) {
    const Submap& submap = submaps_[i];
    const double way_m = ways[submap.first_node()];
    if (way_m < 2 * params_.sure_way_m) continue;
    const double window_m = std::min(0.5 + params_.drift_share * way_m, params_.largest_window_m);
    if (distance_to(submap, poses()[node]) > params_.loop_reach_m + window_m) continue;
    if (points.empty()) points = recent_points(node);
    const Pose guess = relative(poses()[submap.first_node()], poses()[node]);
    const double turn_rad = std::min(0.15 + 0.002 * way_m, 0.6);
    const auto match = find_loop(awake(i), points, guess, {window_m, turn_rad}, params_.loop);
    if (!match) continue;
    closed = accept({i, submap.first_node(), node, match->pose, match->information}) || closed;
  }
  return closed;
}

bool GlobalMapper::accept(const LoopCandidate& candidate) {
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

void GlobalMapper::rebuild() {
  awake_.clear();
  for (Submap& submap : submaps_) {
    std::vector<Scan> scans;
    std::vector<Pose> in_submap;
    for (const std::size_t node : submap.nodes()) {
      scans.push_back(nodes_[node].scan.unpacked());
      in_submap.push_back(relative(poses()[submap.first_node()], poses()[node]));
    }
    submap.rebuild(scans, in_submap);
  }
}

void GlobalMapper::match_all_again() {
  rebuild();
  std::vector<std::vector<std::size_t>> near;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    near.push_back(near_submaps(node, ways_from(node), params_.most_near_again));
  }
  graph_.drop_doubtful();
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const Points points = thin(node);
    for (const std::size_t index : near[node]) {
      const Submap& submap = awake(index);
      const Pose guess = relative(poses()[submap.first_node()], poses()[node]);
      add_near(submap, node, points, refine(submap.field(), points, guess, guess));
    }
  }
  SolveParams solve;
  solve.graduated = false;
  graph_.solve(solve);
}

void GlobalMapper::finish(std::vector<Submap> last) {
  for (Submap& submap : last) submaps_.push_back(std::move(submap));
  graph_.solve();
  for (int pass = 0; pass < params_.passes; ++pass) match_all_again();
}

std::optional<Pose> GlobalMapper::locate(const Scan& scan, const Pose& guess, double reach_m,
                                         const SearchWindow& window) const {
  const Points points = laser::thinned(scan.hits, params_.local.thin_m);
  SearchParams search_params;
  search_params.min_score = params_.loop.min_score * 0.9;
  std::optional<Pose> best;
  double best_score = params_.loop.min_score;
  for (std::size_t i = 0; i < submaps_.size(); ++i) {
    if (distance_to(submaps_[i], guess) > reach_m) continue;
    const Submap& submap = awake(i);
    const Pose& first = poses()[submap.first_node()];
    const auto found =
        search(submap.bounds(), points, relative(first, guess), window, search_params);
    if (!found) continue;
    const Match match = refine(submap.field(), points, found->pose, found->pose);
    if (match.score <= best_score) continue;
    best_score = match.score;
    best = compose(first, match.pose);
  }
  return best;
}

}  // namespace tocsin::mapping
