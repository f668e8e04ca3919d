// SPDX-License-Identifier: Apache-2.0
#include "geometry/pose.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tocsin::geometry {
namespace {

TEST(WrapAngle, KeepsAnglesWithinHalfATurn) {
  EXPECT_DOUBLE_EQ(wrap_angle(0.5), 0.5);
  EXPECT_NEAR(wrap_angle(3 * pi / 2), -pi / 2, 1e-12);
  EXPECT_NEAR(wrap_angle(-3 * pi / 2), pi / 2, 1e-12);
  EXPECT_NEAR(wrap_angle(7 * pi + 0.1), -pi + 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(wrap_angle(std::numeric_limits<double>::infinity())));
}

TEST(WrapAngle, HalfATurnIsPositive) {
  EXPECT_EQ(wrap_angle(pi), pi);
  EXPECT_EQ(wrap_angle(-pi), pi);
  EXPECT_NEAR(wrap_angle(3 * pi), pi, 1e-12);
  EXPECT_GT(wrap_angle(std::nextafter(-pi, -4)), 0);
  EXPECT_LT(wrap_angle(std::nextafter(-pi, 0)), 0);
}

TEST(Quaternion, GivesTheHeadingItWasMadeFromWhateverItsLength) {
  for (const double heading_rad : {-3.0, -0.7, 0.0, 1.2, 3.1}) {
    EXPECT_NEAR(heading_of(quaternion_of(heading_rad)), heading_rad, 1e-12);
  }
  EXPECT_NEAR(heading_of({0, 0, 2 * std::sin(0.4), 2 * std::cos(0.4)}), 0.8, 1e-12);
}

TEST(Points, HaveADistanceABearingAndWhatLiesBetween) {
  EXPECT_DOUBLE_EQ(distance({1, 1}, {4, 5}), 5);
  EXPECT_NEAR(bearing({1, 1}, {0, 1}), pi, 1e-12);
  EXPECT_NEAR(bearing({1, 1}, {1, 3}), pi / 2, 1e-12);
  const Point quarter = between({0, 2}, {4, 0}, 0.25);
  EXPECT_DOUBLE_EQ(quarter.x_m, 1);
  EXPECT_DOUBLE_EQ(quarter.y_m, 1.5);
}

TEST(Compose, MovesAPoseIntoTheFrameOfAnother) {
  const Pose pose = compose({1, 2, pi / 2}, {1, 0, pi / 2});
  EXPECT_NEAR(pose.x_m, 1, 1e-12);
  EXPECT_NEAR(pose.y_m, 3, 1e-12);
  EXPECT_NEAR(std::abs(pose.heading_rad), pi, 1e-12);
}

TEST(IsFinite, RefusesEachNanAndInfinity) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite(Pose{1, 2, 3}));
  EXPECT_FALSE(is_finite(Pose{nan, 2, 3}));
  EXPECT_FALSE(is_finite(Pose{1, infinity, 3}));
  EXPECT_FALSE(is_finite(Pose{1, 2, nan}));
}

}  // namespace
}  // namespace tocsin::geometry
