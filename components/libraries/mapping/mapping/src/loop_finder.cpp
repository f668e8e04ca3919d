// SPDX-License-Identifier: Apache-2.0
#include "mapping/loop_finder.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::mapping {

using geometry::compose;
using geometry::Pose;

std::optional<Match> find_loop(const Submap& submap, const Points& points, const Pose& guess,
                               const SearchWindow& window, const LoopParams& params) {
  SearchParams search_params;
  search_params.min_score = params.min_score * 0.9;  // the grid's steps cost some of the score
  search_params.resolved_range_m = params.resolved_range_m;
  const auto best = search(submap.bounds(), points, guess, window, search_params);
  if (!best) return std::nullopt;
  Match match = refine(submap.field(), points, best->pose, best->pose);
  if (match.score < params.min_score) return std::nullopt;
  const Agreement agreement = submap.agreement(points, match.pose);
  if (agreement.seen < params.min_seen || agreement.opposed > params.max_opposed) {
    return std::nullopt;
  }
  search_params.min_score = best->score * params.max_second;
  search_params.excluded = best->pose;
  search_params.excluded_window = {params.second_from_m, params.second_from_rad};
  if (search(submap.bounds(), points, guess, window, search_params)) return std::nullopt;
  return match;
}

bool LoopJury::agree(const LoopCandidate& a, const LoopCandidate& b,
                     const std::vector<Pose>& local) const {
  // From the place of `a` by its node to that of `b`, and back from submap to submap.
  const Pose nodes = relative(local[a.node], local[b.node]);
  const Pose submaps = relative(local[a.submap_node], local[b.submap_node]);
  const Pose by_nodes = compose(a.relative, nodes);
  const Pose by_submaps = compose(submaps, b.relative);
  const Pose open = relative(by_nodes, by_submaps);
  const double way_m = std::hypot(nodes.x_m, nodes.y_m) + std::hypot(submaps.x_m, submaps.y_m);
  return std::hypot(open.x_m, open.y_m) <= tolerance_.distance_m + tolerance_.share * way_m &&
         std::abs(open.heading_rad) <= tolerance_.turn_rad + tolerance_.turn_rad_per_m * way_m;
}

std::vector<LoopCandidate> LoopJury::on_candidate(const LoopCandidate& candidate,
                                                  const std::vector<Pose>& local) {
  std::vector<LoopCandidate> accepted;
  const auto agrees = [&](const LoopCandidate& other) {
    return other.node != candidate.node && agree(other, candidate, local);
  };
  std::copy_if(waiting_.begin(), waiting_.end(), std::back_inserter(accepted), agrees);
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), agrees), waiting_.end());
  if (accepted.empty()) {
    waiting_.push_back(candidate);
    if (waiting_.size() > most_waiting) waiting_.erase(waiting_.begin());
    return accepted;
  }
  accepted.push_back(candidate);
  return accepted;
}

}  // namespace tocsin::mapping
