// SPDX-License-Identifier: Apache-2.0
#include "random_world.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::bench {
namespace {

using geometry::Point;
using geometry::Wall;
using navigation::Cell;

constexpr double cell_m = 0.05;
constexpr double rim_m = 0.5;  // of what is around the building
constexpr double least_room_m = 2.5;

struct Room {
  double x1, y1, x2, y2;
  [[nodiscard]] double width() const { return x2 - x1; }
  [[nodiscard]] double height() const { return y2 - y1; }
};

class Builder {
 public:
  explicit Builder(std::uint64_t seed) : random_(seed) {}

  World build(WorldKind kind) {
    const Room hull{0, 0, uniform(6, 12), uniform(6, 12)};
    wall({0, 0}, {hull.x2, 0});
    wall({hull.x2, 0}, {hull.x2, hull.y2});
    wall({hull.x2, hull.y2}, {0, hull.y2});
    wall({0, hull.y2}, {0, 0});
    if (kind == WorldKind::rooms) divide(hull);
    if (kind == WorldKind::corridor) along_corridor(hull);
    const double share = kind == WorldKind::clutter ? 0.5 : 0.2;
    clutter(hull, static_cast<int>(share * hull.width() * hull.height()));
    navigation::OccupancyMap empty = rasterised(hull, {});
    navigation::OccupancyMap truth = rasterised(hull, obstacles_);
    const Point start = free_place(hull, truth);
    return {std::move(walls_), std::move(obstacles_), std::move(truth), std::move(empty), start};
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }

  void wall(const Point& a, const Point& b) { walls_.push_back({a.x_m, a.y_m, b.x_m, b.y_m, 6.9}); }

  /// With a door somewhere.
  void inner_wall(const Point& a, const Point& b) {
    const double length_m = distance(a, b);
    const double door_m = uniform(0.8, 1.2);
    const double from_m = uniform(0.3, length_m - door_m - 0.3);
    wall(a, between(a, b, from_m / length_m));
    wall(between(a, b, (from_m + door_m) / length_m), b);
  }

  void divide(const Room& room) {
    const bool is_upright = room.width() > room.height();
    const double side_m = std::max(room.width(), room.height());
    if (side_m < 2 * least_room_m) return;
    const double at_m = uniform(least_room_m, side_m - least_room_m);
    if (is_upright) {
      const double x = room.x1 + at_m;
      inner_wall({x, room.y1}, {x, room.y2});
      divide({room.x1, room.y1, x, room.y2});
      divide({x, room.y1, room.x2, room.y2});
    } else {
      const double y = room.y1 + at_m;
      inner_wall({room.x1, y}, {room.x2, y});
      divide({room.x1, room.y1, room.x2, y});
      divide({room.x1, y, room.x2, room.y2});
    }
  }

  void along_corridor(const Room& hull) {
    const double low = hull.height() / 2 - 0.8;
    const double high = hull.height() / 2 + 0.8;
    for (double x = 0; x < hull.x2 - 1.8;) {
      double next = x + uniform(1.9, 3.5);
      if (next > hull.x2 - 1.9) next = hull.x2;
      inner_wall({x, low}, {next, low});
      inner_wall({x, high}, {next, high});
      if (next < hull.x2) wall({next, 0}, {next, low});
      if (next < hull.x2) wall({next, high}, {next, hull.y2});
      x = next;
    }
  }

  void clutter(const Room& hull, int count) {
    for (int i = 0; i < count; ++i) {
      const Point at{uniform(0, hull.x2), uniform(0, hull.y2)};
      if (i % 2 == 0) {
        obstacles_.boxes.push_back(
            {{at.x_m, at.y_m, uniform(-pi, pi)}, uniform(0.2, 0.9), uniform(0.2, 0.6)});
      } else {
        obstacles_.discs.push_back({at, uniform(0.02, 0.15)});
      }
    }
  }

  navigation::OccupancyMap rasterised(const Room& hull, const laser::Obstacles& obstacles) const {
    const auto cells_of = [](double m) {
      return static_cast<int>(std::ceil((m + 2 * rim_m) / cell_m));
    };
    const navigation::Grid grid{cells_of(hull.x2), cells_of(hull.y2), cell_m, {-rim_m, -rim_m}};
    std::vector<Cell> cells(grid.size(), Cell::free);
    const auto mark = [&](const Point& p) {
      if (const auto cell = grid.cell_of(p)) cells[grid.offset(*cell)] = Cell::occupied;
    };
    auto lines = laser::sides_of(obstacles.boxes);
    lines.insert(lines.end(), walls_.begin(), walls_.end());
    for (const Wall& line : lines) mark_line(line, mark);
    for (const laser::Disc& disc : obstacles.discs) mark_disc(disc, mark);
    return {grid, std::move(cells)};
  }

  template <class Mark>
  static void mark_line(const Wall& line, const Mark& mark) {
    const Point a{line.x1_m, line.y1_m};
    const Point b{line.x2_m, line.y2_m};
    const int steps = 1 + static_cast<int>(distance(a, b) / (cell_m / 4));
    for (int i = 0; i <= steps; ++i) mark(between(a, b, double(i) / steps));
  }

  template <class Mark>
  static void mark_disc(const laser::Disc& disc, const Mark& mark) {
    for (int i = 0; i < 64; ++i) {
      const double bearing_rad = i * pi / 32;
      mark({disc.centre.x_m + disc.radius_m * std::cos(bearing_rad),
            disc.centre.y_m + disc.radius_m * std::sin(bearing_rad)});
    }
  }

  Point free_place(const Room& hull, const navigation::OccupancyMap& truth) {
    Point place{hull.x2 / 2, hull.y2 / 2};
    for (int i = 0; i < 1000 && truth.collides(place.x_m, place.y_m, 0.4); ++i) {
      place = {uniform(0.5, hull.x2 - 0.5), uniform(0.5, hull.y2 - 0.5)};
    }
    return place;
  }

  std::mt19937_64 random_;
  std::vector<Wall> walls_;
  laser::Obstacles obstacles_;
};

}  // namespace

const char* to_string(WorldKind kind) {
  switch (kind) {
    case WorldKind::rooms:
      return "rooms";
    case WorldKind::corridor:
      return "corridor";
    case WorldKind::clutter:
      return "clutter";
  }
  return "";
}

World random_world(WorldKind kind, std::uint64_t seed) { return Builder(seed).build(kind); }

}  // namespace tocsin::bench
