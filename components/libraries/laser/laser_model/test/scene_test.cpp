// SPDX-License-Identifier: Apache-2.0
#include "laser_model/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::laser {
namespace {

const std::vector<geometry::Wall> wall_ahead{{3, -1, 3, 1, 6.9}};

TEST(Scene, MeetsTheNearestOfWallsBoxesDiscsAndWalkers) {
  Obstacles obstacles;
  EXPECT_NEAR(Scene(wall_ahead).range({}, 0, 10), 3, 1e-12);
  obstacles.boxes.push_back({{2.5, 0, pi / 2}, 0.6, 0.4});
  EXPECT_NEAR(Scene(wall_ahead, obstacles).range({}, 0, 10), 2.3, 1e-12) << "turned, its width";
  obstacles.discs.push_back({{2, 0}, 0.1});
  EXPECT_NEAR(Scene(wall_ahead, obstacles).range({}, 0, 10), 1.9, 1e-12);
  obstacles.walkers.push_back({{{1, 0}, {1, 5}}, 1, 0, 0.2});
  Scene sut(wall_ahead, obstacles);
  EXPECT_NEAR(sut.range({}, 0, 10), 0.8, 1e-12);
  sut.set_time(2);
  EXPECT_NEAR(sut.range({}, 0, 10), 1.9, 1e-12) << "he has gone";
  EXPECT_NEAR(sut.range({}, std::atan2(2, 1), 10), std::sqrt(5.0) - 0.2, 1e-12);
}

TEST(Scene, MeetsNothingBehindBesideOrTooFar) {
  Obstacles obstacles;
  obstacles.discs.push_back({{-1, 0}, 0.1});
  obstacles.discs.push_back({{1, 0.11}, 0.1});
  const Scene sut(wall_ahead, obstacles);
  EXPECT_NEAR(sut.range({}, 0, 10), 3, 1e-12);
  EXPECT_EQ(sut.range({}, 0, 2.9), infinity);
  EXPECT_EQ(sut.range({}, pi / 2, 10), infinity);
}

TEST(Scene, TellsWhatADiscTouches) {
  Obstacles obstacles;
  obstacles.discs.push_back({{0, 1}, 0.1});
  const Scene sut(wall_ahead, obstacles);
  EXPECT_TRUE(sut.touched(0, 0, 0.9).empty());
  const auto bearings = sut.touched(0, 0, 0.91);
  ASSERT_EQ(bearings.size(), 1U);
  EXPECT_NEAR(bearings[0], pi / 2, 1e-12);
  EXPECT_EQ(sut.touched(2.9, 0.5, 0.2).size(), 1U);
}

TEST(Walker, WalksToAndFroAndPausesAtBothEnds) {
  const Walker walker{{{0, 0}, {2, 0}, {2, 1}}, 0.5, 2, 0.2};  // 6 s there, 2 s pause, back
  struct Row {
    double time_s;
    double x_m;
    double y_m;
  };
  for (const Row& row :
       {Row{0, 0, 0}, Row{2, 1, 0}, Row{5, 2, 0.5}, Row{6, 2, 1}, Row{7.9, 2, 1}, Row{9, 2, 0.5},
        Row{14, 0, 0}, Row{15.9, 0, 0}, Row{18, 1, 0}, Row{16e8 + 2, 1, 0}, Row{-14, 1, 0}}) {
    const auto place = place_of(walker, row.time_s);
    EXPECT_NEAR(place.x_m, row.x_m, 1e-6) << row.time_s;
    EXPECT_NEAR(place.y_m, row.y_m, 1e-6) << row.time_s;
  }
}

}  // namespace
}  // namespace tocsin::laser
