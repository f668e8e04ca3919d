// SPDX-License-Identifier: Apache-2.0
#include "localisation/localiser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "foundation/numbers.hpp"
#include "laser_model/laser_model.hpp"

namespace tocsin::localisation {
namespace {

using geometry::Point;
using geometry::Pose;
using geometry::Wall;

/// A hall of 8 m x 6 m with a corner cut out and a pillar: no two places look alike.
std::vector<Wall> hall() {
  return {{0, 0, 8, 0, 1},       {8, 0, 8, 6, 1},   {8, 6, 3, 6, 1},   {3, 6, 3, 4.5, 1},
          {3, 4.5, 0, 4.5, 1},   {0, 4.5, 0, 0, 1}, {5, 2, 5.6, 2, 1}, {5.6, 2, 5.6, 2.4, 1},
          {5.6, 2.4, 5, 2.4, 1}, {5, 2.4, 5, 2, 1}};
}

/// The same hall twice, with a wall between: 8 m farther along x all is alike.
std::vector<Wall> twins() {
  std::vector<Wall> walls;
  for (const Wall& wall : hall()) {
    walls.push_back(wall);
    walls.push_back({wall.x1_m + 8, wall.y1_m, wall.x2_m + 8, wall.y2_m, 1});
  }
  return walls;
}

navigation::OccupancyMap map_of(const std::vector<Wall>& walls) {
  const navigation::Grid grid{360, 160, 0.05, {-1, -1}};
  std::vector<navigation::Cell> cells(grid.size(), navigation::Cell::free);
  for (const Wall& wall : walls) {
    for (int i = 0; i <= 800; ++i) {
      const Point at = geometry::between({wall.x1_m, wall.y1_m}, {wall.x2_m, wall.y2_m}, i / 800.0);
      cells[grid.offset(*grid.cell_of(at))] = navigation::Cell::occupied;
    }
  }
  return {grid, cells};
}

/// A vehicle that drives circles of 1 m radius, and a localiser that follows it.
class LocaliserTest : public ::testing::Test {
 protected:
  explicit LocaliserTest(const std::vector<Wall>& walls = hall())
      : walls_(walls), sut(map_of(walls), {}) {}

  std::optional<Localiser::Estimate> step(double way_m = 0.05) {
    const Pose moved{way_m, 0, way_m};
    truth_ = compose(truth_, moved);
    odom_ = compose(odom_, {way_m * odometry_scale_, 0, way_m});
    const laser::Scene scene(walls_, obstacles_);
    const auto ranges_m = laser_.turn(scene, 180, 0, [this](double) { return truth_; });
    laser::ScanParams params;
    params.max_range_m = 12;
    return sut.update(laser::make_scan(ranges_m, {{}, -pi, 2 * degree, 0, {}}, params), odom_);
  }
  Localiser::Estimate run(int steps) {
    std::optional<Localiser::Estimate> estimate;
    for (int i = 0; i < steps; ++i) estimate = step();
    return estimate.value_or(Localiser::Estimate{});
  }
  [[nodiscard]] double off_m(const Localiser::Estimate& estimate) const {
    return distance(position(estimate.belief.pose), position(truth_));
  }

  std::vector<Wall> walls_;
  laser::Obstacles obstacles_;
  laser::LaserModel laser_{laser::find_laser_profile("rplidar_a2"), 1};
  Pose truth_{2.5, 1, 0};
  Pose odom_{7, -3, 1};
  double odometry_scale_ = 1;
  Localiser sut;
};

class TwinsTest : public LocaliserTest {
 protected:
  TwinsTest() : LocaliserTest(twins()) {}
};

TEST_F(LocaliserTest, KeepsToTheTruthWhateverOdometryAddsUpTo) {
  odometry_scale_ = 1.05;
  sut.start_at({2.6, 0.9, 0.05}, 0.2, 0.1);
  double worst_m = 0;
  for (int i = 0; i < 300; ++i) {
    const auto estimate = step();
    ASSERT_TRUE(estimate);
    if (i > 10) worst_m = std::max(worst_m, off_m(*estimate));
  }
  EXPECT_LT(worst_m, 0.05);
  EXPECT_EQ(run(1).health, Health::tracked);
}

TEST_F(LocaliserTest, FindsItselfFromAnywhereAndIsSureOnlyThen) {
  sut.start_anywhere();
  for (int i = 0; i < 100; ++i) {
    const auto estimate = step();
    const bool is_sure = estimate && estimate->health == Health::tracked;
    EXPECT_TRUE(!is_sure || off_m(*estimate) < 0.1) << i;
  }
  EXPECT_EQ(run(1).health, Health::tracked);
}

TEST_F(LocaliserTest, IsNotMisledByWhatNoMapShows) {
  for (const Point& at : {Point{1.5, 2}, {4, 1}, {3.8, 3.2}, {1, 3.5}, {6.5, 4}}) {
    obstacles_.boxes.push_back({{at.x_m, at.y_m, 0.4}, 0.5, 0.4});
  }
  truth_ = {2.5, 2.2, 0};
  sut.start_at(truth_, 0.1, 0.05);
  const auto estimate = run(130);
  EXPECT_LT(off_m(estimate), 0.06);
  EXPECT_EQ(estimate.health, Health::tracked);
  EXPECT_LT(estimate.explained, 0.95);
}

TEST_F(LocaliserTest, StaysSureAmongBoxesOnceItIs) {
  sut.start_at(truth_, 0.1, 0.05);
  EXPECT_EQ(run(30).health, Health::tracked);
  double least = 1;
  for (int i = 0; i < 40; ++i) {
    if (i % 3 == 0) {  // one more on its left or right
      const Pose beside = compose(truth_, {0.4, i % 2 == 0 ? 0.9 : -0.9, 0});
      obstacles_.boxes.push_back({beside, 0.6, 0.6});
    }
    const auto estimate = step(0.03);
    EXPECT_EQ(estimate->health, Health::tracked) << i;
    least = std::min(least, estimate->explained);
  }
  EXPECT_LT(least, 0.5);
  EXPECT_LT(off_m(run(1)), 0.1);
}

TEST_F(TwinsTest, CountsAScanOfAVehicleThatStandsWhenAsked) {
  sut.start_anywhere();
  (void)run(30);
  (void)step(0);
  const double before = sut.hypotheses().front().evidence;
  (void)step(0);
  EXPECT_DOUBLE_EQ(sut.hypotheses().front().evidence, before);
  sut.count_next();
  (void)step(0);
  EXPECT_NE(sut.hypotheses().front().evidence, before);
}

TEST_F(LocaliserTest, FindsItselfWhileItStandsWhereNoOtherPlaceIsLikeIt) {
  sut.start_anywhere();
  std::optional<Localiser::Estimate> estimate;
  for (int i = 0; i < 150; ++i) estimate = step(0);
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->health, Health::tracked);
  EXPECT_LT(off_m(*estimate), 0.1);
}

TEST_F(LocaliserTest, NoticesThatItWasCarriedOffAndFindsItselfAgain) {
  sut.start_at(truth_, 0.1, 0.05);
  (void)run(50);
  truth_ = {6.5, 4.5, 2};
  bool is_noticed = false;
  for (int i = 0; i < 25; ++i) {
    const auto estimate = step();
    is_noticed = is_noticed || estimate->health != Health::tracked;
    if (i < 10) continue;
    EXPECT_TRUE(estimate->health != Health::tracked || off_m(*estimate) < 0.1) << i;
  }
  EXPECT_TRUE(is_noticed);
  const auto estimate = run(120);
  EXPECT_EQ(estimate.health, Health::tracked);
  EXPECT_LT(off_m(estimate), 0.1);
}

TEST_F(LocaliserTest, WheelsThatTurnInVainDoNotMoveIt) {
  sut.start_at(truth_, 0.1, 0.05);
  (void)run(20);
  for (int i = 0; i < 20; ++i) {
    odom_ = compose(odom_, {0.1, 0, 0});  // 2 m
    (void)step(0);
  }
  EXPECT_LT(off_m(run(5)), 0.15);
}

TEST_F(LocaliserTest, OdometryThatBeginsAnewDoesNotMoveIt) {
  sut.start_at(truth_, 0.1, 0.05);
  (void)run(30);
  odom_ = {};
  EXPECT_LT(off_m(*step()), 0.1);
  EXPECT_LT(off_m(run(20)), 0.05);
}

TEST_F(LocaliserTest, IsNotSureOfAStartThatDoesNotFit) {
  sut.start_at({6.5, 4.5, 2}, 0.1, 0.05);
  EXPECT_NE(step()->health, Health::tracked);
}

TEST_F(TwinsTest, RoomsThatAreAlikeStayTwoHypotheses) {
  sut.start_anywhere();
  for (int i = 0; i < 300; ++i) {
    const auto estimate = step();
    if (!estimate || estimate->health != Health::tracked) continue;
    EXPECT_LT(off_m(*estimate), 0.3) << "sure and wrong after " << i;
  }
  EXPECT_GE(sut.hypotheses().size(), 2U);
  EXPECT_GT(run(1).belief.covariance(0, 0), 1) << "8 m apart";
}

TEST_F(LocaliserTest, SaysNothingBeforeAStartAndOfScansThatAreNone) {
  EXPECT_FALSE(step());
  sut.start_at(truth_, 0.1, 0.1);
  EXPECT_TRUE(step());
  EXPECT_FALSE(sut.update({}, odom_));
  EXPECT_FALSE(sut.update({{}, {{1, 0}}, {}, {}}, {nan, 0, 0}));
  EXPECT_TRUE(step());
}

}  // namespace
}  // namespace tocsin::localisation
