// SPDX-License-Identifier: Apache-2.0
#include "navigation/geometry.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::navigation {
namespace {

TEST(WrapAngle, KeepsAnglesWithinHalfATurn) {
  EXPECT_DOUBLE_EQ(wrap_angle(0.5), 0.5);
  EXPECT_NEAR(wrap_angle(3 * pi / 2), -pi / 2, 1e-12);
  EXPECT_NEAR(wrap_angle(-3 * pi / 2), pi / 2, 1e-12);
  EXPECT_NEAR(wrap_angle(7 * pi + 0.1), -pi + 0.1, 1e-12);
}

TEST(Quaternion, GivesTheYawItWasMadeFrom) {
  for (const double yaw : {-3.0, -0.7, 0.0, 1.2, 3.1}) {
    EXPECT_NEAR(yaw_of(quaternion_from_yaw(yaw)), yaw, 1e-12);
  }
}

TEST(Quaternion, YawIgnoresLength) {
  EXPECT_NEAR(yaw_of({0, 0, 2 * std::sin(0.4), 2 * std::cos(0.4)}), 0.8, 1e-12);
}

TEST(Quaternion, YawOfTheThesisFirstWaypoint) {
  EXPECT_NEAR(yaw_of({0, 0, 0.5380338078016184, 0.842923259652082}), 1.1362, 1e-4);
}

TEST(Bearing, PointsFromTheFirstToTheSecond) {
  EXPECT_NEAR(bearing({1, 1}, {0, 1}), pi, 1e-12);
  EXPECT_NEAR(bearing({1, 1}, {1, 3}), pi / 2, 1e-12);
}

TEST(Compose, MovesAPoseIntoTheFrameOfAnother) {
  const Pose2 pose = compose({1, 2, pi / 2}, {1, 0, pi / 2});
  EXPECT_NEAR(pose.x, 1, 1e-12);
  EXPECT_NEAR(pose.y, 3, 1e-12);
  EXPECT_NEAR(std::abs(pose.yaw), pi, 1e-12);
}

TEST(IsFinite, RefusesEachNanAndInfinity) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite(Pose2{1, 2, 3}));
  EXPECT_FALSE(is_finite(Pose2{nan, 2, 3}));
  EXPECT_FALSE(is_finite(Pose2{1, infinity, 3}));
  EXPECT_FALSE(is_finite(Pose2{1, 2, nan}));
}

}  // namespace
}  // namespace tocsin::navigation
