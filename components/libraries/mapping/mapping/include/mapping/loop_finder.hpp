// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mapping/scan_matcher.hpp"
#include "mapping/submap.hpp"

namespace tocsin::mapping {

struct LoopParams {
  double min_score = 0.5;   ///< mean value of the field
  double max_second = 0.9;  ///< of the best score: as good a place elsewhere is ambiguous
  double min_seen = 0.6;    ///< of Agreement
  double max_opposed = 0.15;
  double resolved_range_m = 5.0;  ///< of SearchParams: refining bridges what is coarser
  double second_from_m = 0.8;     ///< the second best place is one as far away as this,
  double second_from_rad = 0.3;   ///< or turned as much
};

/// Looks for points that were seen just now in a finished submap. Empty when they do not lie there,
/// when two places are about as good, or when the submap has seen that nothing is there.
[[nodiscard]] std::optional<Match> find_loop(const Submap& submap, const Points& points,
                                             const geometry::Pose& guess,
                                             const SearchWindow& window,
                                             const LoopParams& params = {});

/// A recognised place that no second one has confirmed.
struct LoopCandidate {
  std::size_t submap = 0;       ///< index
  std::size_t submap_node = 0;  ///< its first node
  std::size_t node = 0;         ///< that was recognised
  geometry::Pose relative;      ///< of `node` in the frame of `submap_node`
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Accepts what two candidates agree on: the way from node to node round both is closed.
class LoopJury {
 public:
  /// How far a closed way may be open: a part that does not depend on its length, and one that
  /// does.
  struct Tolerance {
    double distance_m = 0.3;
    double turn_rad = 0.06;
    double share = 0.03;  ///< of the way between the nodes
    double turn_rad_per_m = 0.005;
  };

  LoopJury() = default;
  explicit LoopJury(const Tolerance& tolerance) : tolerance_(tolerance) {}

  /// Returns what is accepted now: nothing, or `candidate` and those older ones that agree with it.
  /// `local` are the drifting poses of all nodes.
  std::vector<LoopCandidate> on_candidate(const LoopCandidate& candidate,
                                          const std::vector<geometry::Pose>& local);

 private:
  [[nodiscard]] bool agree(const LoopCandidate& a, const LoopCandidate& b,
                           const std::vector<geometry::Pose>& local) const;

  static constexpr std::size_t most_waiting = 50;
  Tolerance tolerance_;
  std::vector<LoopCandidate> waiting_;
};

}  // namespace tocsin::mapping
