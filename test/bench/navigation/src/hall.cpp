// SPDX-License-Identifier: Apache-2.0
#include "hall.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::bench {
namespace {

using geometry::Point;
using geometry::Wall;
using navigation::Cell;

constexpr double width_m = 30;
constexpr double height_m = 20;
constexpr double cell_m = 0.1;
constexpr double rack_db = 5;
constexpr double dead_share = 0.25;

std::mt19937_64 random_of(std::uint64_t seed) { return std::mt19937_64(seed * 7919 + 13); }

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<>(low, high)(random);
}

}  // namespace

Hall::Hall(std::uint64_t seed)
    : walls_([&] {
        auto random = random_of(seed);
        return racks(random);
      }()),
      floor_(rasterised()),
      radio_([&] {
        auto random = random_of(seed + 1'000'000);
        return propagation(random);
      }()) {
  auto random = random_of(seed + 2'000'000);
  std::vector<double> signals;
  for (int i = 0; i < 400; ++i) signals.push_back(mean_dbm(free_place(random)));
  std::sort(signals.begin(), signals.end());
  power_db_ = half_dbm - signals[static_cast<std::size_t>(dead_share * 400)];
}

/// Rows along x, each in pieces with a gap between them.
std::vector<Wall> Hall::racks(std::mt19937_64& random) {
  std::vector<Wall> walls{{0, 0, width_m, 0, 20},
                          {width_m, 0, width_m, height_m, 20},
                          {width_m, height_m, 0, height_m, 20},
                          {0, height_m, 0, 0, 20}};
  for (double y = 2.5; y < height_m - 2; y += uniform(random, 2.2, 3.2)) {
    for (double x = uniform(random, 1.5, 3); x < width_m - 3;) {
      const double end = std::min(x + uniform(random, 3, 8), width_m - 1.5);
      walls.push_back({x, y, end, y, rack_db});
      x = end + uniform(random, 1.2, 2.5);
    }
  }
  return walls;
}

navigation::OccupancyMap Hall::rasterised() const {
  const navigation::Grid grid{static_cast<int>(width_m / cell_m) + 2,
                              static_cast<int>(height_m / cell_m) + 2,
                              cell_m,
                              {-cell_m, -cell_m}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (const Wall& wall : walls_) {
    const Point a{wall.x1_m, wall.y1_m};
    const Point b{wall.x2_m, wall.y2_m};
    const int steps = 1 + static_cast<int>(distance(a, b) / (cell_m / 4));
    for (int i = 0; i <= steps; ++i) {
      const auto cell = grid.cell_of(between(a, b, double(i) / steps));
      if (cell) cells[grid.offset(*cell)] = Cell::occupied;
    }
  }
  return {grid, std::move(cells)};
}

radio::Propagation Hall::propagation(std::mt19937_64& random) const {
  radio::ChannelParams params;
  params.access_point_x_m = uniform(random, 2, width_m - 2);
  params.access_point_y_m = uniform(random, 2, height_m - 2);
  params.shadowing_sigma_db = 3.2;  // of an office, Malmirchegini and Mostofi (2012)
  params.shadowing_distance_m = 3.1;
  return {params, walls_, random(), Time{}};
}

Point Hall::free_place(std::mt19937_64& random) const {
  while (true) {
    const Point at{uniform(random, 1, width_m - 1), uniform(random, 1, height_m - 1)};
    if (!floor_.collides(at.x_m, at.y_m, 0.4)) return at;
  }
}

double Hall::mean_dbm(const Point& at) {
  radio_.set_position(at.x_m, at.y_m);
  return radio_.mean_rssi_dbm() + power_db_;
}

double Hall::lost_share(double dbm) const { return 1 / (1 + std::exp((dbm - half_dbm) / 2)); }

}  // namespace tocsin::bench
