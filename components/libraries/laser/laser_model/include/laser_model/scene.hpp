// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/pose.hpp"
#include "geometry/wall.hpp"

namespace tocsin::laser {

/// A cylinder: the leg of a chair, a pillar.
struct Disc {
  geometry::Point centre;
  double radius_m = 0.02;
};

/// An upright box.
struct Box {
  geometry::Pose middle;
  double length_m = 0.4;  ///< along its heading
  double width_m = 0.3;
};

/// A person who walks to and fro on a line of straight pieces, and does not look where he walks.
struct Walker {
  geometry::Path way;      ///< at least two different corners
  double speed_mps = 0.8;  ///< above 0
  double pause_s = 1;      ///< at each end
  double radius_m = 0.2;
};

/// Where a walker is. `time_s`: since any moment, such as the Unix epoch.
[[nodiscard]] geometry::Point place_of(const Walker& walker, double time_s);

/// What is not on the map.
struct Obstacles {
  std::vector<Box> boxes;
  std::vector<Disc> discs;
  std::vector<Walker> walkers;
};

/// Eight sides of a disc, no wall of the building: one can look over it.
[[nodiscard]] std::vector<geometry::Wall> sides_of(const Disc& disc);

/// The four sides of each box.
[[nodiscard]] std::vector<geometry::Wall> sides_of(const std::vector<Box>& boxes);

/// Walls and obstacles around a vehicle, at a time. Copies are cheap enough to be values.
class Scene {
 public:
  explicit Scene(std::vector<geometry::Wall> walls = {}, const Obstacles& obstacles = {});

  /// Moves the walkers.
  void set_time(double time_s);
  /// Moves one of them, by its place among the obstacles' walkers.
  void place_walker(std::size_t walker, const geometry::Point& at);
  [[nodiscard]] bool has_walkers() const { return !walkers_.empty(); }

  /// Distance to what is first met from `from` along `bearing_rad` [m]; infinity beyond `most_m`.
  [[nodiscard]] double range(const geometry::Point& from, double bearing_rad, double most_m) const;
  /// Bearings [rad] to the nearest point of all that is nearer to (x, y) than `radius_m`.
  [[nodiscard]] std::vector<double> touched(double x_m, double y_m, double radius_m) const;

 private:
  std::vector<geometry::Wall> walls_;
  std::vector<Walker> walkers_;
  std::vector<Disc> discs_;  ///< the walkers' last
  std::size_t standing_ = 0;
};

}  // namespace tocsin::laser
