// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "laser_model/scene.hpp"

namespace tocsin::laser {

/// What a simulated vehicle touches, and what its laser sees: what is lower than the laser (a dock)
/// only the body meets. Used by one thread.
class Room {
 public:
  Room(const std::vector<geometry::Wall>& walls, const std::vector<geometry::Wall>& low,
       const Obstacles& obstacles);

  /// Moves the walkers to where they are at a time of the wall clock [s]. False: there are none.
  bool set_time(double wall_s);

  [[nodiscard]] std::shared_ptr<const Scene> seen() const { return seen_; }
  /// The bearings of what a disc touches, as Scene::touched.
  [[nodiscard]] std::function<std::vector<double>(double x_m, double y_m, double radius_m)>
  touched() const;

 private:
  std::shared_ptr<Scene> seen_;
  std::shared_ptr<Scene> met_;
};

}  // namespace tocsin::laser
