// SPDX-License-Identifier: Apache-2.0
#include "velocity_smoother/velocity_smoother.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);
constexpr auto period = std::chrono::milliseconds(50);

struct Smoother : ::testing::Test {
  /// Steps with the command repeated each period.
  geometry::Twist drive(const geometry::Twist& command, int steps) {
    for (int i = 0; i < steps; ++i) {
      now += period;
      sut.on_command(command, now);
      velocity = sut.step(now);
    }
    return velocity;
  }
  geometry::Twist coast(int steps) {
    for (int i = 0; i < steps; ++i) velocity = sut.step(now += period);
    return velocity;
  }
  VelocitySmoother sut{VelocitySmoother::Params{}};
  geometry::Twist velocity;
  Time now = t0;
};

TEST_F(Smoother, AcceleratesWithTheLimit) {
  EXPECT_NEAR(drive({0.5, 0}, 1).linear_mps, 0.015, 1e-12);  // 0.3 m/s2 * 50 ms
  EXPECT_NEAR(drive({0.5, 0}, 9).linear_mps, 0.15, 1e-12);
  EXPECT_DOUBLE_EQ(drive({0.5, 0}, 100).linear_mps, 0.5);
}

TEST_F(Smoother, KeepsTheRadiusWhileAccelerating) {
  for (int i = 0; i < 20; ++i) {
    drive({0.4, 0.8}, 1);
    EXPECT_NEAR(velocity.linear_mps / velocity.angular_rad_s, 0.5, 1e-9);
  }
}

TEST_F(Smoother, ScalesFastCommandsAsAWhole) {
  drive({1.6, 1.0}, 200);
  EXPECT_NEAR(velocity.linear_mps, 0.8, 1e-9);
  EXPECT_NEAR(velocity.angular_rad_s, 0.5, 1e-9);
}

TEST_F(Smoother, BrakesToZeroWhenTheSourceFallsSilent) {
  drive({0.3, 0}, 50);
  coast(4);  // 0.2 s are still fresh
  EXPECT_DOUBLE_EQ(velocity.linear_mps, 0.3);
  coast(1);
  EXPECT_LT(velocity.linear_mps, 0.3);
  coast(20);
  EXPECT_EQ(velocity.linear_mps, 0);
  EXPECT_TRUE(sut.at_rest(now));
}

TEST_F(Smoother, WaitsForThreePeriodsOfASlowSource) {
  for (int i = 0; i < 40; ++i) {
    if (i % 2 == 0) sut.on_command({0.3, 0}, now);
    velocity = sut.step(now += period);
  }
  coast(4);  // 0.3 s after the last command
  EXPECT_DOUBLE_EQ(velocity.linear_mps, 0.3);
  coast(1);
  EXPECT_LT(velocity.linear_mps, 0.3);
}

TEST_F(Smoother, BrakesByTheDecelFactor) {
  VelocitySmoother::Params params;
  params.decel_factor = 2;
  sut = VelocitySmoother(params);
  drive({0.3, 0}, 50);
  EXPECT_NEAR(drive({0, 0}, 1).linear_mps, 0.27, 1e-9);
}

TEST_F(Smoother, ReversesThroughZero) {
  drive({0.15, 0}, 20);
  drive({-0.15, 0}, 10);
  EXPECT_NEAR(velocity.linear_mps, 0, 1e-9);
  EXPECT_NEAR(drive({-0.15, 0}, 20).linear_mps, -0.15, 1e-9);
}

TEST_F(Smoother, HasNothingToDoAtRest) {
  EXPECT_EQ(sut.next_deadline(now), never);
  EXPECT_FALSE(sut.update(now));
  sut.on_command({0, 0}, now);
  EXPECT_EQ(sut.next_deadline(now), never);
}

TEST_F(Smoother, AnswersTheFirstCommandAtOnceAndStepsWithItsPeriod) {
  sut.on_command({0.03, 0}, now);
  EXPECT_DOUBLE_EQ(sut.update(now)->linear_mps, 0.015);
  EXPECT_EQ(sut.next_deadline(now), now + period);
  EXPECT_FALSE(sut.update(now + period - std::chrono::nanoseconds(1)));
  EXPECT_DOUBLE_EQ(sut.update(now + period)->linear_mps, 0.03);
}

TEST_F(Smoother, OtherLimitsHoldForWhatIsDrivenAlready) {
  drive({0.5, 0}, 100);
  VelocitySmoother::Params slow;
  slow.speed_lim_v_mps = 0.2;
  sut.set_limits(slow);
  const auto braked = sut.step(now += period);
  EXPECT_NEAR(braked.linear_mps, 0.485, 1e-9);  // within the acceleration limit
  EXPECT_NEAR(drive({0.5, 0}, 100).linear_mps, 0.2, 1e-9);
  VelocitySmoother::Params brisk;
  brisk.accel_lim_v_mps2 = 0.6;
  sut.set_limits(brisk);
  EXPECT_NEAR(drive({0.5, 0}, 1).linear_mps, 0.23, 1e-9);
}

}  // namespace
}  // namespace tocsin
