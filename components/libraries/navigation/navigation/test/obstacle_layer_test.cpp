// SPDX-License-Identifier: Apache-2.0
#include "navigation/obstacle_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::navigation {
namespace {

using geometry::Point;

/// A floor of 10 m x 10 m with a wall along x = 4, and a laser in its middle.
class ObstacleLayerTest : public ::testing::Test {
 protected:
  static OccupancyMap floor() {
    const Grid grid{200, 200, 0.05, {-5, -5}};
    std::vector<Cell> cells(grid.size(), Cell::free);
    for (int row = 0; row < 200; ++row) cells[grid.offset({180, row})] = Cell::occupied;
    return {grid, cells};
  }
  /// A turn of 360 beams that meets a disc of 0.1 m radius at each of these places, else nothing.
  static laser::Scan seen(const std::vector<Point>& discs, double clears_m = 4) {
    laser::Scan scan;
    for (int i = 0; i < 360; ++i) {
      const double bearing_rad = i * degree;
      const Point direction{std::cos(bearing_rad), std::sin(bearing_rad)};
      double range_m = infinity;
      for (const Point& disc : discs) {
        const double ahead_m = disc.x_m * direction.x_m + disc.y_m * direction.y_m;
        const double beside_m = disc.x_m * direction.y_m - disc.y_m * direction.x_m;
        if (ahead_m > 0 && std::abs(beside_m) < 0.1) range_m = std::min(range_m, ahead_m - 0.1);
      }
      auto& points = range_m < clears_m ? scan.hits : scan.open;
      const double length_m = std::min(range_m, clears_m);
      points.push_back({length_m * direction.x_m, length_m * direction.y_m});
    }
    return scan;
  }
  void look(const std::vector<Point>& discs, double after_s = 0.1) {
    now_ += seconds(after_s);
    sut_.on_scan(seen(discs), {}, now_);
    sut_.forget(now_);
  }

  Time now_ = Time{} + seconds(100);
  ObstacleLayer sut_{floor(), {}};
};

TEST_F(ObstacleLayerTest, MarksWhatIsSeenOnFreeFloor) {
  look({{2, 0}});
  EXPECT_TRUE(sut_.touches({1.9, 0}, 0.06));
  EXPECT_FALSE(sut_.touches({1.5, 0}, 0.3));
  EXPECT_NEAR(sut_.distance_m({1.4, 0}, 2), 0.5, 0.05);
  EXPECT_EQ(sut_.distance_m({-2, 0}, 1), 1) << "nothing there";
}

TEST_F(ObstacleLayerTest, WallsOfTheMapAndWhatIsFarAreNone) {
  look({{4.05, 0.5}, {3.9, -0.5}, {-3.8, 0}});
  EXPECT_TRUE(sut_.cells().empty());
}

TEST_F(ObstacleLayerTest, WhatIsGoneIsClearedBySightWithTheSecondTurn) {
  look({{2, 0}});
  const std::uint64_t marked = sut_.version();
  look({});
  EXPECT_EQ(sut_.version(), marked) << "one turn may miss";
  look({{2, 0}});
  look({});
  EXPECT_FALSE(sut_.cells().empty()) << "seen again in between";
  look({});
  EXPECT_TRUE(sut_.cells().empty());
  EXPECT_NE(sut_.version(), marked);
}

TEST_F(ObstacleLayerTest, WhatHasComeLatelyFarAwayMayWalk) {
  look({{2.5, 0}, {0, 1}});
  const auto is_lasting = [&](const Point& from, const Point& at) {
    for (const CellIndex& cell : sut_.lasting_cells(from, now_)) {
      if (distance(floor().grid().centre(cell), at) < 0.15) return true;
    }
    return false;
  };
  EXPECT_FALSE(is_lasting({0, 0}, {2.4, 0}));
  EXPECT_TRUE(is_lasting({0, 0}, {0, 0.9})) << "it is near";
  EXPECT_TRUE(is_lasting({1, 0}, {2.4, 0})) << "it is near from there";
  for (int i = 0; i < 99; ++i) look({{2.5, 0}, {0, 1}});
  EXPECT_FALSE(is_lasting({0, 0}, {2.4, 0})) << "for 9.9 s";
  look({{2.5, 0}, {0, 1}});
  EXPECT_TRUE(is_lasting({0, 0}, {2.4, 0})) << "it stands there";
}

TEST_F(ObstacleLayerTest, WhatWasTouchedFarAwayDoesNotWalk) {
  sut_.on_touch({3, 1}, now_);
  EXPECT_EQ(sut_.lasting_cells({0, 0}, now_).size(), 1U);
}

TEST_F(ObstacleLayerTest, WhatIsHiddenStaysForItsTime) {
  look({{2, 0}});
  look({{1, 0}});
  for (int i = 0; i < 10; ++i) look({{1, 0}});
  EXPECT_TRUE(sut_.touches({1.9, 0}, 0.06)) << "behind the other";
  for (int i = 0; i < 11; ++i) look({{1, 0}}, 3);
  EXPECT_FALSE(sut_.touches({1.9, 0}, 0.06)) << "after 30 s";
  EXPECT_TRUE(sut_.touches({0.9, 0}, 0.06));
}

TEST_F(ObstacleLayerTest, WhatWasTouchedStaysThoughBeamsPassOverIt) {
  sut_.on_touch({1, 1}, now_);
  for (int i = 0; i < 39; ++i) look({}, 3);
  EXPECT_TRUE(sut_.touches({1, 1}, 0.06)) << "117 s";
  look({}, 3);
  look({}, 3);
  EXPECT_TRUE(sut_.cells().empty());
}

TEST_F(ObstacleLayerTest, WhatWasTouchedAndIsSeenGoesWhenItWalksAway) {
  look({{0.3, 0}});
  sut_.on_touch({0.2, 0.1}, now_);
  look({});
  look({});
  EXPECT_FALSE(sut_.touches({0.2, 0.1}, 0.1));
  sut_.on_touch({0.2, 0.1}, now_);
  look({});
  look({});
  EXPECT_TRUE(sut_.touches({0.2, 0.1}, 0.1)) << "no beam met this one";
}

TEST_F(ObstacleLayerTest, SeesFromWhereTheVehicleStands) {
  sut_.on_scan(seen({{2, 0}}), {1, -2, pi / 2}, now_);
  EXPECT_TRUE(sut_.touches({1, -0.1}, 0.06));
}

TEST_F(ObstacleLayerTest, PlacesOutsideOfTheMapAreNoObstaclesAndNoHarm) {
  sut_.on_scan(seen({{2, 0}}), {1e9, 0, 0}, now_);
  sut_.on_touch({nan, 0}, now_);
  EXPECT_TRUE(sut_.cells().empty());
  look({{2, 0}});
  EXPECT_FALSE(sut_.touches({1e12, -1e12}, 0.5));
  EXPECT_FALSE(sut_.touches({nan, 0}, 0.5));
}

}  // namespace
}  // namespace tocsin::navigation
