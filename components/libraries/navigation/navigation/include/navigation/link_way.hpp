// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "navigation/cost_map.hpp"
#include "navigation/link_risk.hpp"
#include "navigation/planner.hpp"

namespace tocsin::navigation {

/// A way, and the metres of it on which the link is expected to be lost.
struct LinkWay {
  geometry::Path path;
  double length_m = 0;
  double silent_m = 0;
};

/// The way that was chosen beside the shortest one.
struct WayChoice {
  LinkWay way;
  LinkWay shortest;  ///< its path is empty where it is the way
};

/// Chooses the way on which the link is lost least, of those that are longer than the shortest one
/// by a bounded share of what is driven: what one goal leaves of it (at most 10 m), the next ones
/// may use. A metre without link is worth at most 8 m of driving.
///
/// Remembers what is used up on the way to a goal, so that half of a detour is not given up. Pure.
class LinkWayChooser {
 public:
  /// `most_detour`: share of the shortest way [range 0,1].
  explicit LinkWayChooser(double most_detour) : most_detour_(most_detour) {}

  /// The next way leads to another goal.
  void begin();
  /// `shortest` leads from where the vehicle is now, over `costs`; `risks` is `risk.on` their grid.
  [[nodiscard]] WayChoice choose(geometry::Path shortest, const CostMap& costs,
                                 const LinkRisk& risk, const std::vector<float>& risks);

 private:
  [[nodiscard]] std::optional<LinkWay> better(const LinkWay& plain, const CostMap& costs,
                                              const LinkRisk& risk,
                                              const std::vector<float>& risks) const;
  double most_detour_;
  double spare_m_ = 0;            ///< that goals before have left
  double saved_m_ = 0;            ///< the same, once this one is reached
  std::optional<double> left_m_;  ///< that the way to this goal may still be long
  geometry::Point asked_at_;
};

}  // namespace tocsin::navigation
