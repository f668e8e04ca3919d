// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/velocity_hold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

TEST(VelocityHold, HoldsACommandUntilItIsStale) {
  VelocityHold sut{VelocityParams{}};
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
  sut.on_command({0.3, 0.5}, t0);
  sut.stop();
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
  sut.on_command({0.3, 0.5}, t0);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.6)).linear_mps, 0.3);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.601)).linear_mps, 0);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.601)).angular_rad_s, 0);
}

TEST(VelocityHold, ScalesFastCommandsAndKeepsTheRadius) {
  VelocityHold sut{VelocityParams{}};
  sut.on_command({1.4, 1.0}, t0);
  EXPECT_NEAR(sut.velocity(t0).linear_mps, 0.7, 1e-12);
  EXPECT_NEAR(sut.velocity(t0).angular_rad_s, 0.5, 1e-12);
  sut.on_command({-0.4, -2 * M_PI}, t0);
  EXPECT_NEAR(sut.velocity(t0).linear_mps, -0.2, 1e-12);
  EXPECT_NEAR(sut.velocity(t0).angular_rad_s, -M_PI, 1e-12);
}

TEST(VelocityHold, StopsOnNumbersThatAreNone) {
  VelocityHold sut{VelocityParams{}};
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    sut.on_command({0.3, 0}, t0);
    sut.on_command({0.3, bad}, t0);
    EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
    sut.on_command({bad, 0.1}, t0);
    EXPECT_EQ(sut.velocity(t0).angular_rad_s, 0);
  }
}

TEST(VelocityHold, StandsWhileHeldWhateverIsCommandedAndThenWaitsForACommand) {
  VelocityHold sut{VelocityParams{}};
  sut.on_command({0.3, 0}, t0);
  sut.hold(true);
  EXPECT_TRUE(sut.is_held());
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
  sut.on_command({0.5, 1}, t0);
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
  EXPECT_EQ(sut.velocity(t0).angular_rad_s, 0);
  sut.hold(false);
  EXPECT_FALSE(sut.is_held());
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
  sut.on_command({0.2, 0}, t0);
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0.2);
}

}  // namespace
}  // namespace tocsin::kobuki
