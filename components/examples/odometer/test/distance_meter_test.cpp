// SPDX-License-Identifier: Apache-2.0
#include "odometer/distance_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace example {
namespace {

constexpr double step_m = 0.02;
constexpr double jump_m = 0.5;

class DistanceMeterTest : public ::testing::Test {
 protected:
  double at(double x_m, double y_m) {
    sut_.on_position(x_m, y_m);
    return sut_.driven_m();
  }
  DistanceMeter sut_{step_m, jump_m};
};

TEST_F(DistanceMeterTest, TheFirstPositionIsNoDriveWhereverItIs) {
  EXPECT_EQ(sut_.driven_m(), 0);
  EXPECT_EQ(at(100, -100), 0);
}

TEST_F(DistanceMeterTest, AddsUpTheWayAndNotTheDistanceFromTheStart) {
  at(0, 0);
  at(0.3, 0.4);
  EXPECT_NEAR(at(0, 0), 1.0, 1e-12);
}

TEST_F(DistanceMeterTest, CountsFromTheStepOn) {
  at(0, 0);
  EXPECT_EQ(at(std::nextafter(step_m, 0), 0), 0);
  EXPECT_EQ(at(step_m, 0), step_m);
}

TEST_F(DistanceMeterTest, NoiseOfAStandingVehicleAddsNothing) {
  at(0, 0);
  for (int i = 0; i < 1000; ++i) at(i % 2 == 0 ? 0.009 : -0.009, 0);
  EXPECT_EQ(sut_.driven_m(), 0);
}

TEST_F(DistanceMeterTest, SlowDrivingAddsUpThoughEachPoseIsLessThanAStepFromTheOneBefore) {
  for (int i = 0; i <= 1000; ++i) at(0.001 * i, 0);
  EXPECT_NEAR(sut_.driven_m(), 1.0, step_m);
}

TEST_F(DistanceMeterTest, AJumpAddsNothingAndWhatFollowsIsMeasuredFromThere) {
  at(0, 0);
  EXPECT_EQ(at(jump_m, 0), jump_m);
  EXPECT_EQ(at(2 * jump_m + 0.001, 0), jump_m);
  EXPECT_NEAR(at(2 * jump_m + 0.101, 0), jump_m + 0.1, 1e-12);
}

TEST_F(DistanceMeterTest, IgnoresNumbersThatAreNone) {
  at(0, 0);
  at(std::nan(""), 0);
  at(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(at(0.1, 0), 0.1);
}

}  // namespace
}  // namespace example
