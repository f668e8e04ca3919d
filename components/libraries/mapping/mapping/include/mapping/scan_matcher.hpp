// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "laser_geometry/scan.hpp"
#include "mapping/likelihood_field.hpp"

namespace tocsin::mapping {

/// Where to look, on both sides of the guess.
struct SearchWindow {
  double distance_m = 0.3;
  double turn_rad = 0.26;
};

/// A pose at which points lie best on a field.
struct Match {
  geometry::Pose pose;
  double score = 0;  ///< mean value of the field at the points [range 0,1]
  /// Inverse covariance of the pose in the field's frame [1/m^2, 1/rad^2]; nearly 0 along a
  /// direction that the points do not tell of (a corridor).
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// What the search asks of a pose.
struct SearchParams {
  double min_score = 0.3;  ///< worse is no match
  /// Taken off the score at the border of the window, with the square of the distance to the guess:
  /// decides where points tell nothing.
  double guess_weight = 0.0;
  /// Points farther from the vehicle turn by more than a cell between two headings; 0: none does.
  double resolved_range_m = 10.0;
  /// No match within this of `excluded` is wanted (the second best is looked for).
  std::optional<geometry::Pose> excluded;
  SearchWindow excluded_window{1.0, 0.3};
};

/// The best of all poses of a window, by branch and bound, to one cell and one step of heading:
/// none that is better is missed (Olson, ICRA 2009; Hess et al., ICRA 2016). Empty when none
/// reaches `min_score`. Equal scores: the one that is found first in a fixed order.
[[nodiscard]] std::optional<Match> search(const FieldBounds& bounds, const Points& points,
                                          const geometry::Pose& guess, const SearchWindow& window,
                                          const SearchParams& params = {});

/// How strongly refining holds to its guess: standard deviations of the guess; infinite: not at
/// all.
struct GuessTrust {
  double distance_m = infinity;
  double turn_rad = infinity;
};

/// Climbs from `start` to the nearest pose with the best sum of the field, by damped Gauss-Newton
/// of the points' distances to the walls with the weight of Welsch, which the field is; good from
/// starts within about two sigma of the field. Always ends after a bounded time.
[[nodiscard]] Match refine(const LikelihoodField& field, const Points& points,
                           const geometry::Pose& start, const geometry::Pose& guess,
                           const GuessTrust& trust = {});

/// Whether a match that was refined from `guess` is where a search would end, too: it fits, and is
/// within sigma of the guess, where there is one summit.
[[nodiscard]] bool is_sure(const Match& match, const geometry::Pose& guess,
                           const LikelihoodField& field, double sure_score);

}  // namespace tocsin::mapping
