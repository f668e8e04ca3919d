// SPDX-License-Identifier: Apache-2.0
#include "localisation/beam_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::localisation {
namespace {

using geometry::Point;
using geometry::Pose;
using navigation::Cell;

/// A floor of 10 m x 10 m with short walls everywhere.
navigation::OccupancyMap rubble(std::mt19937& random) {
  const navigation::Grid grid{200, 200, 0.05, {-5, -5}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int i = 0; i < 60; ++i) {
    const int column = static_cast<int>(random() % 180);
    const int row = static_cast<int>(random() % 180);
    const bool is_upright = random() % 2 == 0;
    for (int k = 0; k < 15; ++k) {
      cells[grid.offset({column + (is_upright ? 0 : k), row + (is_upright ? k : 0)})] =
          Cell::occupied;
    }
  }
  return {grid, std::move(cells)};
}

TEST(BeamModelTest, ABeamGoesThroughTheWallsThatLieOnIt) {
  std::mt19937 random(3);
  std::uniform_real_distribution<> place_m(-6, 6);  // outside, too
  const navigation::OccupancyMap map = rubble(random);
  const DistanceMap distances(map);
  const BeamModel sut(map, distances);
  int through = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose pose{place_m(random), place_m(random), place_m(random)};
    const Point hit{place_m(random), place_m(random)};
    const Point there = laser::transformed({hit}, pose).front();
    const double range_m = std::hypot(hit.x_m, hit.y_m);
    const auto wall_m = map.raycast(position(pose), bearing(position(pose), there), range_m);
    const bool is_beside_wall = distances.sample(there).distance_m < 0.2;
    const bool is_through = !is_beside_wall && wall_m && *wall_m + 0.3 < range_m;
    laser::Scan scan;
    scan.hits = {hit};
    EXPECT_EQ(sut.evidence_of(scan, pose).through, is_through ? 1 : 0) << i;
    through += is_through ? 1 : 0;
  }
  EXPECT_GT(through, 500);
}

}  // namespace
}  // namespace tocsin::localisation
