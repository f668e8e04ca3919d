// SPDX-License-Identifier: Apache-2.0
#include "laser_model/room.hpp"

namespace tocsin::laser {
namespace {

std::vector<geometry::Wall> all(std::vector<geometry::Wall> walls,
                                const std::vector<geometry::Wall>& low) {
  walls.insert(walls.end(), low.begin(), low.end());
  return walls;
}

}  // namespace

Room::Room(const std::vector<geometry::Wall>& walls, const std::vector<geometry::Wall>& low,
           const Obstacles& obstacles)
    : seen_(std::make_shared<Scene>(walls, obstacles)),
      met_(std::make_shared<Scene>(all(walls, low), obstacles)) {}

bool Room::set_time(double wall_s) {
  if (!seen_->has_walkers()) return false;
  seen_->set_time(wall_s);
  met_->set_time(wall_s);
  return true;
}

std::function<std::vector<double>(double x_m, double y_m, double radius_m)> Room::touched() const {
  return [met = met_](double x_m, double y_m, double radius_m) {
    return met->touched(x_m, y_m, radius_m);
  };
}

}  // namespace tocsin::laser
