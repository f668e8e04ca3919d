// SPDX-License-Identifier: Apache-2.0
/// What the navigator does about what a laser sees and the map has not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "vehicle.hpp"

namespace tocsin {
namespace {

using geometry::Point;

constexpr double disc_m = 0.2;  // radius of an obstacle

Navigator::Params avoiding() {
  Navigator::Params params;
  params.surroundings.avoid_obstacles = true;
  params.retry_after_s = 60;
  return params;
}

/// A floor of 8 m x 4 m without walls, a vehicle whose laser turns ten times a second.
class NavigatorObstaclesTest : public ::testing::Test {
 protected:
  Navigator::Output step() {
    if (has_laser_ && ++steps_ % 2 == 0) look();
    const auto output = vehicle_.step();
    for (const Point& disc : discs_) {
      nearest_m_ = std::min(nearest_m_, distance(position(vehicle_.pose), disc) - disc_m - 0.18);
    }
    return output;
  }
  Navigator::Output run(double s) {
    Navigator::Output output;
    for (int i = 0; i < std::lround(s / 0.05); ++i) output = step();
    return output;
  }
  void look() {
    laser::Scan scan;
    for (int i = 0; i < 360; ++i) {
      const double bearing_rad = i * degree + vehicle_.pose.heading_rad;
      double range_m = 4;
      for (const Point& disc : discs_) range_m = std::min(range_m, range_to(disc, bearing_rad));
      auto& points = range_m < 4 ? scan.hits : scan.open;
      points.push_back({range_m * std::cos(i * degree), range_m * std::sin(i * degree)});
    }
    vehicle_.sut.on_scan(scan, vehicle_.pose, vehicle_.now);
  }
  [[nodiscard]] double range_to(const Point& disc, double bearing_rad) const {
    const double dx = disc.x_m - vehicle_.pose.x_m;
    const double dy = disc.y_m - vehicle_.pose.y_m;
    const double ahead_m = dx * std::cos(bearing_rad) + dy * std::sin(bearing_rad);
    const double beside_m = dx * std::sin(bearing_rad) - dy * std::cos(bearing_rad);
    if (ahead_m <= 0 || std::abs(beside_m) >= disc_m) return infinity;
    return ahead_m - std::sqrt(disc_m * disc_m - beside_m * beside_m);
  }
  /// From wall to wall across the floor.
  void close_the_way(double x_m) {
    for (double y_m = 0.1; y_m < 4; y_m += 0.35) discs_.push_back({x_m, y_m});
  }

  Vehicle vehicle_{avoiding(), 0};
  std::vector<Point> discs_;
  bool has_laser_ = true;
  int steps_ = 0;
  double nearest_m_ = infinity;
};

TEST_F(NavigatorObstaclesTest, DrivesRoundWhatNoMapShows) {
  discs_ = {{3, 1}, {4, 1.7}, {5, 0.9}};
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  EXPECT_EQ(run(30).status.state, State::reached);
  EXPECT_GT(nearest_m_, 0.03);
}

TEST_F(NavigatorObstaclesTest, StandsWithoutAScanAndGoesOnWithTheNext) {
  has_laser_ = false;
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  EXPECT_EQ(run(1).status.reason, std::string("no_scan"));
  has_laser_ = true;
  EXPECT_EQ(run(2).status.state, State::driving);
  has_laser_ = false;
  (void)run(0.9);
  EXPECT_GT(step().velocity.linear_mps, 0);
  const auto output = run(0.4);
  EXPECT_EQ(output.status.state, State::held);
  EXPECT_EQ(output.velocity.linear_mps, 0);
}

TEST_F(NavigatorObstaclesTest, WaitsWhereEverythingIsClosedAndGoesOnWhenItOpens) {
  close_the_way(4);
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  const auto output = run(15);
  EXPECT_EQ(output.status.state, State::blocked);
  EXPECT_EQ(output.status.reason, std::string("no_path"));
  EXPECT_GT(nearest_m_, 0.03);
  discs_.clear();
  EXPECT_EQ(run(25).status.state, State::reached);
}

TEST_F(NavigatorObstaclesTest, DrivesUpToWhatClosesItsOnlyWayFarAhead) {
  close_the_way(5);
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  EXPECT_EQ(run(20).status.state, State::blocked);
  EXPECT_GT(vehicle_.pose.x_m, 2.5);
  EXPECT_GT(nearest_m_, 0.03);
  discs_.clear();
  EXPECT_EQ(run(15).status.state, State::reached);
}

TEST_F(NavigatorObstaclesTest, FollowsWhoWalksAheadOfIt) {
  double x_m = 3;
  close_the_way(x_m);
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  for (int i = 0; i < 150; ++i) {
    (void)run(0.1);
    x_m += 0.04;
    discs_.clear();
    close_the_way(x_m);
  }
  EXPECT_GT(vehicle_.pose.x_m, 5);
  EXPECT_GT(nearest_m_, 0.03);
}

TEST_F(NavigatorObstaclesTest, GoesOnAsSoonAsWhatClosedTheWayHasGone) {
  close_the_way(3);
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  EXPECT_EQ(run(15).status.state, State::blocked);
  discs_.clear();
  EXPECT_EQ(run(1.5).status.state, State::driving);  // retry_after_s is 60
}

TEST_F(NavigatorObstaclesTest, PlansAnewAtMostOnceASecondWhenSomethingStepsIntoItsWay) {
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  (void)run(4);
  discs_ = {{vehicle_.pose.x_m + 1.5, 1}};
  EXPECT_EQ(run(30).status.state, State::reached);
  EXPECT_GT(nearest_m_, 0.03);
}

TEST_F(NavigatorObstaclesTest, IsSlowerBetweenObstacles) {
  discs_ = {{3, 1.55}, {3, 0.45}};
  for (double y_m = 1.9; y_m < 4; y_m += 0.35) discs_.push_back({3, y_m});
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  double slowest_mps = 1;
  while (vehicle_.pose.x_m < 5) {
    const double speed_mps = step().velocity.linear_mps;
    if (vehicle_.pose.x_m > 2.5 && vehicle_.pose.x_m < 3.5) {
      slowest_mps = std::min(slowest_mps, speed_mps);
    }
  }
  EXPECT_LT(slowest_mps, 0.45);
  EXPECT_GT(slowest_mps, 0.1);
}

TEST_F(NavigatorObstaclesTest, GoesRoundWhatItHasBumpedIntoThoughNoBeamSeesIt) {
  ASSERT_EQ(vehicle_.send(1, {7, 1, 0}), Answer::accepted);
  while (vehicle_.pose.x_m < 3) (void)step();
  vehicle_.sut.on_touch(0, 0.2, vehicle_.now);
  const Point bumped{vehicle_.pose.x_m + 0.2, vehicle_.pose.y_m};
  EXPECT_EQ(run(40).status.state, State::reached);
  ASSERT_EQ(vehicle_.send(2, {1, 1, 0}), Answer::accepted);
  double nearest_m = infinity;
  for (int i = 0; i < 600; ++i) {
    (void)step();
    nearest_m = std::min(nearest_m, distance(position(vehicle_.pose), bumped));
  }
  EXPECT_LE(vehicle_.distance_to({1, 1, 0}), 0.2);
  EXPECT_GT(nearest_m, 0.2) << "on the way back, too";
}

TEST_F(NavigatorObstaclesTest, PassesAGapThatTheMarginWouldClose) {
  // 0.46 m between them, and walls of discs to both sides.
  for (double y_m = 0.1; y_m < 1.5; y_m += 0.35) discs_.push_back({4, y_m});
  discs_.push_back({4, 1.57});
  for (double y_m = 2.43; y_m < 4; y_m += 0.35) discs_.push_back({4, y_m});
  ASSERT_EQ(vehicle_.send(1, {7, 2, 0}), Answer::accepted);
  EXPECT_EQ(run(60).status.state, State::reached);
  EXPECT_GT(nearest_m_, 0);
}

TEST_F(NavigatorObstaclesTest, LooksAroundWhenItDoesNotKnowWhereItIs) {
  Navigator::Params params = avoiding();
  params.look_around = true;
  Vehicle vehicle(params, 0);
  ASSERT_EQ(vehicle.send(1, {7, 1, 0}), Answer::accepted);
  vehicle.sut.on_scan({}, vehicle.pose, vehicle.now);
  (void)vehicle.step();
  vehicle.has_localisation = false;
  EXPECT_EQ(vehicle.run(2.9).velocity.angular_rad_s, 0);
  const auto looking = vehicle.run(2);
  EXPECT_EQ(looking.velocity.linear_mps, 0);
  EXPECT_NEAR(looking.velocity.angular_rad_s, 0.5, 1e-9);
  EXPECT_EQ(looking.status.state, State::held);
  vehicle.sut.on_emergency_stop(true);
  EXPECT_EQ(vehicle.step().velocity.angular_rad_s, 0);
  vehicle.sut.on_emergency_stop(false);
}

TEST_F(NavigatorObstaclesTest, DrivesALittleWhereTurningHasNotToldWhereItIs) {
  Navigator::Params params = avoiding();
  params.look_around = true;
  Vehicle vehicle(params, 0);
  vehicle.has_localisation = false;
  ASSERT_EQ(vehicle.send(1, {7, 1, 0}), Answer::accepted);
  (void)vehicle.run(34);
  laser::Scan scan;
  scan.hits = {{3, 0}};
  vehicle.sut.on_scan(scan, std::nullopt, vehicle.now);
  EXPECT_GT(vehicle.run(0.4).velocity.linear_mps, 0.05);
  EXPECT_EQ(vehicle.run(1).velocity.linear_mps, 0) << "without a new scan";
}

TEST_F(NavigatorObstaclesTest, LooksAroundWithAGoalThoughItNeverKnewWhereItIs) {
  Navigator::Params params = avoiding();
  params.look_around = true;
  Vehicle vehicle(params, 0);
  vehicle.has_localisation = false;
  EXPECT_EQ(vehicle.run(5).velocity.angular_rad_s, 0) << "without a goal it stands";
  ASSERT_EQ(vehicle.send(1, {7, 1, 0}), Answer::accepted);
  vehicle.sut.on_scan({}, vehicle.pose, vehicle.now);
  EXPECT_EQ(vehicle.run(2.5).velocity.angular_rad_s, 0);
  EXPECT_NEAR(vehicle.run(2).velocity.angular_rad_s, 0.5, 1e-9);
}

TEST(NavigatorWithoutLaser, NeedsNoScan) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(15).status.state, State::reached);
}

}  // namespace
}  // namespace tocsin
