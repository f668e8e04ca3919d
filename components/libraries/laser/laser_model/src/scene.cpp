// SPDX-License-Identifier: Apache-2.0
#include "laser_model/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

using geometry::Point;
using geometry::Wall;

/// How far along the unit direction (c, s) the wall is met; infinity when it is not.
double range_to(const Wall& wall, const Point& from, double c, double s) {
  const double ex = wall.x2_m - wall.x1_m;
  const double ey = wall.y2_m - wall.y1_m;
  const double dx = wall.x1_m - from.x_m;
  const double dy = wall.y1_m - from.y_m;
  const double cross = c * ey - s * ex;
  if (cross == 0) return infinity;
  const double along = (dx * s - dy * c) / cross;
  if (along < 0 || along > 1) return infinity;
  const double range_m = (dx * ey - dy * ex) / cross;
  return range_m > 0 ? range_m : infinity;
}

double range_to(const Disc& disc, const Point& from, double c, double s) {
  const double dx = disc.centre.x_m - from.x_m;
  const double dy = disc.centre.y_m - from.y_m;
  const double ahead = dx * c + dy * s;
  const double beside2 = dx * dx + dy * dy - ahead * ahead;
  const double radius2 = disc.radius_m * disc.radius_m;
  if (ahead <= 0 || beside2 > radius2) return infinity;
  return std::max(0.0, ahead - std::sqrt(radius2 - beside2));
}

double length_of(const geometry::Path& way) {
  double length_m = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length_m += geometry::distance(way[i - 1], way[i]);
  return length_m;
}

Point at_length(const geometry::Path& way, double length_m) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece_m = geometry::distance(way[i - 1], way[i]);
    if (length_m <= piece_m && piece_m > 0) {
      return geometry::between(way[i - 1], way[i], length_m / piece_m);
    }
    length_m -= piece_m;
  }
  return way.back();
}

}  // namespace

Point place_of(const Walker& walker, double time_s) {
  const double walk_s = length_of(walker.way) / walker.speed_mps;
  const double half_s = walk_s + walker.pause_s;
  double in_round_s = std::fmod(time_s, 2 * half_s);
  if (in_round_s < 0) in_round_s += 2 * half_s;
  const bool comes_back = in_round_s >= half_s;
  const double walked_s = std::min(comes_back ? in_round_s - half_s : in_round_s, walk_s);
  const double length_m = walked_s * walker.speed_mps;
  return at_length(walker.way, comes_back ? length_of(walker.way) - length_m : length_m);
}

std::vector<Wall> sides_of(const Disc& disc) {
  constexpr int count = 8;
  std::vector<Wall> sides;
  const auto corner = [&disc](int i) {
    const double bearing_rad = i * 2 * pi / count;
    return Point{disc.centre.x_m + disc.radius_m * std::cos(bearing_rad),
                 disc.centre.y_m + disc.radius_m * std::sin(bearing_rad)};
  };
  for (int i = 0; i < count; ++i) {
    const Point from = corner(i);
    const Point to = corner(i + 1);
    sides.push_back({from.x_m, from.y_m, to.x_m, to.y_m, 0});
  }
  return sides;
}

std::vector<Wall> sides_of(const std::vector<Box>& boxes) {
  std::vector<Wall> sides;
  for (const Box& box : boxes) {
    std::array<geometry::Pose, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const double ahead_m = (i == 0 || i == 3 ? 0.5 : -0.5) * box.length_m;
      const double left_m = (i < 2 ? 0.5 : -0.5) * box.width_m;
      corners[i] = compose(box.middle, {ahead_m, left_m, 0});
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& a = corners[i];
      const auto& b = corners[(i + 1) % 4];
      sides.push_back({a.x_m, a.y_m, b.x_m, b.y_m, 0});
    }
  }
  return sides;
}

Scene::Scene(std::vector<Wall> walls, const Obstacles& obstacles)
    : walls_(std::move(walls)),
      walkers_(obstacles.walkers),
      discs_(obstacles.discs),
      standing_(discs_.size()) {
  const auto sides = sides_of(obstacles.boxes);
  walls_.insert(walls_.end(), sides.begin(), sides.end());
  for (const Walker& walker : walkers_) discs_.push_back({{}, walker.radius_m});
  set_time(0);
}

void Scene::set_time(double time_s) {
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    place_walker(i, place_of(walkers_[i], time_s));
  }
}

void Scene::place_walker(std::size_t walker, const Point& at) {
  discs_.at(standing_ + walker).centre = at;
}

double Scene::range(const Point& from, double bearing_rad, double most_m) const {
  const double c = std::cos(bearing_rad);
  const double s = std::sin(bearing_rad);
  double nearest_m = infinity;
  for (const Wall& wall : walls_) nearest_m = std::min(nearest_m, range_to(wall, from, c, s));
  for (const Disc& disc : discs_) nearest_m = std::min(nearest_m, range_to(disc, from, c, s));
  return nearest_m <= most_m ? nearest_m : infinity;
}

std::vector<double> Scene::touched(double x_m, double y_m, double radius_m) const {
  const Point here{x_m, y_m};
  std::vector<double> bearings;
  for (const Wall& wall : walls_) {
    const Point nearest = nearest_point(wall, here);
    if (geometry::distance(here, nearest) < radius_m) {
      bearings.push_back(geometry::bearing(here, nearest));
    }
  }
  for (const Disc& disc : discs_) {
    if (geometry::distance(here, disc.centre) < radius_m + disc.radius_m) {
      bearings.push_back(geometry::bearing(here, disc.centre));
    }
  }
  return bearings;
}

}  // namespace tocsin::laser
