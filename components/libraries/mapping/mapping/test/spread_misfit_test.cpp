// SPDX-License-Identifier: Apache-2.0
#include "mapping/spread_misfit.hpp"

#include <gtest/gtest.h>

namespace tocsin::mapping {
namespace {

using geometry::Pose;

TEST(SpreadMisfit, LeavesAnOdometryThatIsRight) {
  const std::vector<Pose> odometry{{5, 5, 0}, {6, 5, 0.1}, {7, 5.2, 0.1}};
  const auto poses = spread_misfit(odometry, {0, 0, 0}, {2, 0.2, 0.1});
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_NEAR(poses[1].x_m, 1, 1e-12);
  EXPECT_NEAR(poses[1].heading_rad, 0.1, 1e-12);
}

TEST(SpreadMisfit, SpreadsByTheWayAndNotByTheNumberOfReadings) {
  const auto poses =
      spread_misfit({{0, 0, 0}, {0, 0, 0}, {3, 0, 0}, {4, 0, 0}}, {0, 0, 0}, {4.4, 0.4, 0});
  EXPECT_NEAR(poses[1].x_m, 0, 1e-12);
  EXPECT_NEAR(poses[2].x_m, 3.3, 1e-12);
  EXPECT_NEAR(poses[2].y_m, 0.3, 1e-12);
  EXPECT_NEAR(poses[3].x_m, 4.4, 1e-12);
}

TEST(SpreadMisfit, FollowsAnArcThatTheWheelsTookForALine) {
  // A quarter of a circle of radius 1 in 90 steps, of which the wheels say that they were straight.
  std::vector<Pose> odometry;
  for (int i = 0; i <= 90; ++i) odometry.push_back({i * degree, 0, 0});
  const auto poses = spread_misfit(odometry, {0, 0, 0}, {1, 1, pi / 2});
  EXPECT_NEAR(poses[45].x_m, std::sin(pi / 4), 1e-3);
  EXPECT_NEAR(poses[45].y_m, 1 - std::cos(pi / 4), 1e-3);
  EXPECT_NEAR(poses[45].heading_rad, pi / 4, 1e-9);
}

TEST(SpreadMisfit, JumpsAtTheEndWhenTheWheelsStoodStill) {
  const auto poses = spread_misfit({{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, {0, 0, 0}, {0.1, 0, 0});
  EXPECT_DOUBLE_EQ(poses[1].x_m, 0);
  EXPECT_DOUBLE_EQ(poses[2].x_m, 0.1);
}

}  // namespace
}  // namespace tocsin::mapping
