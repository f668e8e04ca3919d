// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "odometry_samples.hpp"

namespace tocsin::kobuki {
namespace {

// Rows of the reference: encoders and stamp wrap on the way.
TEST(Odometry, FollowsTheReferenceAcrossWraps) {
  EXPECT_NEAR(tick_m, 8.5292090497737e-5, 1e-15);
  Odometry sut{by_encoder()};
  sut.update(core(65000, 65500, 65400), {});
  EXPECT_EQ(sut.pose().x_m, 0);
  EXPECT_EQ(sut.linear_mps(), 0);
  sut.update(core(65020, 65540, 65460), {});
  EXPECT_NEAR(sut.pose().x_m, 0.004264604, 1e-8);
  EXPECT_NEAR(sut.pose().heading_rad, 0.007416703, 1e-8);
  EXPECT_NEAR(sut.linear_mps(), 0.213230, 1e-5);
  EXPECT_NEAR(sut.angular_rad_s(), 0.370835, 1e-5);
  EXPECT_NEAR(sut.left().angle_rad, 0.097477, 1e-5);
  EXPECT_NEAR(sut.right().rate_rad_s, 7.310750, 1e-5);
  for (int i = 2; i <= 54; ++i)
    sut.update(core(65000 + 20 * i, 65500 + 40 * i, 65400 + 60 * i), {});
  EXPECT_NEAR(sut.pose().x_m, 0.224349084, 1e-7);
  EXPECT_NEAR(sut.pose().y_m, 0.044670844, 1e-7);
  EXPECT_NEAR(sut.pose().heading_rad, 0.400501980, 1e-7);
}

TEST(Odometry, KeepsTheRateWhenTheStampStands) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), {});
  sut.update(core(20, 40, 40), {});
  const double rate = sut.linear_mps();
  sut.update(core(20, 40, 40), {});
  EXPECT_EQ(sut.linear_mps(), rate);
}

TEST(Odometry, TakesTheHeadingFromTheGyroAcrossItsWrap) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(17900));
  sut.update(core(20, 0, 0), inertia(-17900, 500));
  EXPECT_NEAR(sut.pose().heading_rad, 2 * degree, 1e-9);
  EXPECT_NEAR(sut.angular_rad_s(), 5 * degree, 1e-9);
}

TEST(Odometry, StartsAtHeadingZeroWhateverTheGyroSays) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(-6245));
  sut.update(core(20, 50, 50), inertia(-6245));
  EXPECT_EQ(sut.pose().heading_rad, 0);
  EXPECT_NEAR(sut.pose().x_m, 50 * tick_m, 1e-12);
}

TEST(Odometry, TurnsByEncodersWhenInertiaIsMissing) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  sut.update(core(20, -20, 20), {});
  const double turn = 40 * tick_m / wheel_separation_m;
  EXPECT_NEAR(sut.pose().heading_rad, turn, 1e-12);
  sut.update(core(40, -20, 20), inertia(5000));  // no difference to take yet
  EXPECT_NEAR(sut.pose().heading_rad, turn, 1e-12);
}

TEST(Odometry, AppliesScales) {
  OdometryParams params = by_encoder();
  params.left_wheel_scale = 1.02;
  params.right_wheel_scale = 0.98;
  params.wheel_separation_m = 0.246;
  Odometry sut{params};
  sut.update(core(0, 0, 0), {});
  for (int ms = 100; ms <= 1000; ms += 100) sut.update(core(ms, ms, ms), {});
  EXPECT_NEAR(sut.pose().x_m, 1000 * tick_m, 1e-3);
  EXPECT_NEAR(sut.pose().heading_rad, -0.04 * 1000 * tick_m / 0.246, 1e-9);
}

TEST(Odometry, AppliesGyroScaleAndBias) {
  OdometryParams params;
  params.gyro_scale = 1.1;
  params.gyro_bias_rad_s = 1 * degree;
  Odometry sut{params};
  sut.update(core(0, 0, 0), inertia(0));
  for (int i = 1; i <= 10; ++i) {
    sut.update(core(100 * i, 0, 0), inertia(static_cast<std::int16_t>(110 * i), 1100));
  }
  EXPECT_NEAR(sut.pose().heading_rad, 11 * degree, 1e-9);
  EXPECT_NEAR(sut.angular_rad_s(), 11 * degree, 1e-9);
}

TEST(Odometry, DoesNotTakeARestartedBaseForMotion) {
  Odometry sut{by_encoder()};
  sut.update(core(60000, 100, 100), {});
  sut.update(core(60020, 140, 140), {});
  const double x_m = sut.pose().x_m;
  sut.update(core(60040, 62447, 30000), {});  // the reference driver jumps by up to 2.8 m
  EXPECT_EQ(sut.pose().x_m, x_m);
  EXPECT_EQ(sut.rejected_jumps(), 1U);
  sut.update(core(60060, 62487, 30040), {});
  EXPECT_NEAR(sut.pose().x_m, x_m + 40 * tick_m, 1e-9);
}

TEST(Odometry, KeepsTheHeadingWhenTheGyroStartsAnew) {
  Odometry sut{OdometryParams{}};
  sut.update(core(20, 0, 0), inertia(9000));
  sut.update(core(40, 0, 0), inertia(9100));
  sut.update(core(20, 30000, 30000), inertia(0));
  sut.update(core(40, 30000, 30000), inertia(100));
  EXPECT_NEAR(sut.pose().heading_rad, 2 * degree, 1e-9);
}

TEST(Odometry, KeepsTheGyroHeadingBesideEncoderOdometry) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), inertia(0));
  sut.update(core(100, 0, 0), inertia(500, 5000));
  EXPECT_EQ(sut.pose().heading_rad, 0);
  EXPECT_NEAR(sut.gyro_heading_rad(), 5 * degree, 1e-9);
  EXPECT_NEAR(sut.gyro_rate_rad_s(), 50 * degree, 1e-9);
  sut.reset();
  EXPECT_EQ(sut.gyro_heading_rad(), 0);
}

TEST(Odometry, HasAJumpLimitOfMaxWheelSpeed) {
  OdometryParams params = by_encoder();
  params.max_wheel_speed_mps = 1.0;
  const int limit_ticks = static_cast<int>((1.0 * 1.0 + 0.01) / tick_m);
  Odometry at{params};
  at.update(core(0, 0, 0), {});
  at.update(core(1000, limit_ticks, limit_ticks), {});
  EXPECT_EQ(at.rejected_jumps(), 0U);
  Odometry beyond{params};
  beyond.update(core(0, 0, 0), {});
  beyond.update(core(1000, limit_ticks + 1, 0), {});
  EXPECT_EQ(beyond.rejected_jumps(), 1U);
}

TEST(Odometry, GoesToTheOriginWhenReset) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), {});
  sut.update(core(20, 40, 60), {});
  sut.reset();
  EXPECT_EQ(sut.pose().x_m, 0);
  EXPECT_EQ(sut.pose().heading_rad, 0);
  EXPECT_EQ(sut.left().angle_rad, 0);
  sut.update(core(40, 80, 100), {});
  EXPECT_NEAR(sut.pose().x_m, 40 * tick_m, 1e-12);
}

TEST(Odometry, ContinuesFromASnapshotWithTheMotionInBetween) {
  Odometry before{OdometryParams{}};
  EXPECT_FALSE(before.snapshot());
  before.update(core(0, 0, 0), inertia(0));
  before.update(core(20, 40, 40), inertia(100));
  Odometry after{OdometryParams{}};
  after.restore(*before.snapshot());
  before.update(core(1000, 800, 900), inertia(300));
  after.update(core(1000, 800, 900), inertia(300));
  EXPECT_EQ(after.pose().x_m, before.pose().x_m);
  EXPECT_EQ(after.pose().heading_rad, before.pose().heading_rad);
  EXPECT_EQ(after.right().angle_rad, before.right().angle_rad);
}

}  // namespace
}  // namespace tocsin::kobuki
