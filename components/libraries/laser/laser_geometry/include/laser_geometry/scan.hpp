// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/twist.hpp"

namespace tocsin::laser {

using Points = std::vector<geometry::Point>;

/// One turn of a laser, in the frame of the vehicle.
struct Scan {
  geometry::Point laser;  ///< where the beams start [m]
  Points hits;            ///< what they met [m]
  Points misses;          ///< ends of what is free on beams that met nothing [m],
  Points open;  ///< those of them that have like neighbours: one beam may be lost on a wall
  std::vector<float> ranges_m{};  ///< of its hits as they were measured, by beam; NaN: no hit
};

/// How readings of a laser become points.
struct ScanParams {
  double min_range_m = 0.1;   ///< shorter readings are the laser's own housing: ignored
  double max_range_m = 40.0;  ///< this and more is "no return"
  double used_range_m = 30;   ///< longer readings are ignored: their beams lie too far apart
  double cleared_m = 4.0;     ///< how far a beam without return makes the floor free; 0: not at all
  std::size_t open_beams = 5;  ///< so many in a row without return are no fault of the laser
};

/// Where the laser sits on the vehicle, how its beams lie, and how the vehicle moves meanwhile.
struct Beams {
  geometry::Pose laser;        ///< frame of the vehicle
  double first_rad = 0;        ///< bearing of the first beam, frame of the laser
  double increment_rad = 0;    ///< from beam to beam, counter-clockwise
  double interval_s = 0;       ///< from beam to beam
  geometry::Twist velocity{};  ///< of the vehicle
};

/// Points are in the frame of the vehicle at the first beam. NaN is ignored, +inf is "no return"
/// (REP 117).
[[nodiscard]] Scan make_scan(const std::vector<double>& ranges_m, const Beams& beams,
                             const ScanParams& params = {});

/// Whether two turns are one that was sent again, whole or but for a few readings: of the beams
/// that have hit, at least eight, 85 % measured within 0.2 mm what they or their neighbours had
/// measured, since the angles of a laser that turns by itself differ from turn to turn. No two
/// turns of a laser that measures are so alike, and how the vehicle moved meanwhile makes no
/// difference.
[[nodiscard]] bool is_repeated(const Scan& before, const Scan& now);

/// `points`, given in the frame of `pose`, in the frame that `pose` is given in.
[[nodiscard]] Points transformed(const Points& points, const geometry::Pose& pose);

/// `hits`, in the order of their beams, and points at most `spacing_m` apart on the straight walls
/// between them. Where a wall is met at a low angle the beams lie far apart; without the points
/// between, a matcher would lay the next beams onto the last ones, and the vehicle would stand
/// still in a corridor.
[[nodiscard]] Points joined(const Points& hits, double spacing_m);

/// One point of each square of side `cell_m` that has any, the first of each, in their order.
[[nodiscard]] Points thinned(const Points& points, double cell_m);

}  // namespace tocsin::laser
