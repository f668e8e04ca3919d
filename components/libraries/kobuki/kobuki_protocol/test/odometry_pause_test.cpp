// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "odometry_samples.hpp"

namespace tocsin::kobuki {
namespace {

TEST(Odometry, LeavesOutASingleDamagedSample) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  sut.update(core(20, 40, 40), inertia(0));
  sut.update(core(40, 80 ^ 0x2000, 80), inertia(0));  // flipped bits that cancel in the checksum
  sut.update(core(60, 120, 120), inertia(0));
  sut.update(core(80, 160, 160), inertia(0x2000));
  sut.update(core(100, 200, 200), inertia(0));
  EXPECT_NEAR(sut.pose().x_m, 200 * tick_m, 1e-12);
  EXPECT_NEAR(sut.pose().heading_rad, 0, 1e-12);
  EXPECT_EQ(sut.rejected_jumps(), 2U);
}

TEST(Odometry, TakesMotionAcrossGapsThatTheStampsAllow) {
  struct {
    int from_ms, to_ms, ticks;
    unsigned rejected;
  } const gaps[] = {{0, 2000, 16400, 0},  // 0.7 m/s for 2 s
                    {0, 3500, 1000, 0},
                    {0, 3501, 1000, 1},
                    {2000, 20, 3000, 1}};  // the stamp went back
  for (const auto& [from_ms, to_ms, ticks, rejected] : gaps) {
    Odometry sut{by_encoder()};
    sut.update(core(from_ms, 0, 0), {});
    sut.update(core(to_ms, ticks, ticks), {});
    if (rejected == 0) sut.update(core(to_ms, ticks, ticks), {});  // confirms it
    EXPECT_EQ(sut.rejected_jumps(), rejected) << to_ms;
    EXPECT_NEAR(sut.pose().x_m, rejected == 0 ? ticks * tick_m : 0, 1e-3) << to_ms;
  }
}

TEST(Odometry, IsNotTurnedByADamagedSampleAfterAPause) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  sut.update(core(20, 0, 0), inertia(0));
  sut.update(core(1000, 0, 0), inertia(3328));  // possible in a second, but wrong
  sut.update(core(1020, 0, 0), inertia(0));
  sut.update(core(1040, 0, 0), inertia(0));
  EXPECT_NEAR(sut.pose().heading_rad, 0, 1e-9);
}

TEST(Odometry, TakesTheFirstSampleAfterAShortPauseAtOnce) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), {});
  sut.update(core(100, 100, 100), {});
  EXPECT_NEAR(sut.pose().x_m, 100 * tick_m, 1e-9);
  sut.update(core(201, 200, 200), {});
  EXPECT_NEAR(sut.pose().x_m, 100 * tick_m, 1e-9);
  sut.update(core(221, 220, 220), {});
  EXPECT_NEAR(sut.pose().x_m, 220 * tick_m, 1e-9);
}

/// What odometry adds for a silence of `silence_s` after which the base's stamp has gone on by
/// `stamp_s` and both wheels by `ticks`, and the gyro by a degree.
geometry::Pose bridged(double silence_s, double stamp_s, int ticks) {
  Odometry sut{OdometryParams{}};
  sut.update(core(100, 0, 0), inertia(0));
  const int stamp_ms = 100 + static_cast<int>(std::lround(stamp_s * 1000));
  sut.update(core(stamp_ms, ticks, ticks), inertia(100), silence_s);
  EXPECT_TRUE(sut.waits());
  sut.update(core(stamp_ms + 20, ticks, ticks), inertia(100), silence_s + 0.02);
  EXPECT_FALSE(sut.waits());
  return sut.pose();
}

TEST(Odometry, TakesTheWayThatTheBaseRolledInALongSilence) {
  for (const double silence_s : {4.0, 60.0, 70.0, 200.0}) {
    EXPECT_NEAR(bridged(silence_s, silence_s, 4000).x_m, 4000 * tick_m, 1e-4) << silence_s;
    EXPECT_NEAR(bridged(silence_s, silence_s, 4000).heading_rad, degree, 1e-9) << silence_s;
    EXPECT_NEAR(bridged(silence_s, silence_s, -4000).x_m, -4000 * tick_m, 1e-4) << silence_s;
  }
}

TEST(Odometry, UndoesADamagedSampleThatLookedPossible) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  sut.update(core(20, 100, 100), inertia(0));
  sut.update(core(100, 500, 500), inertia(0));
  sut.update(core(180, 900, 900), inertia(4000));  // 40 degrees in 80 ms: possible, but wrong
  sut.update(core(200, 1000, 1000), inertia(0));   // not in 20 ms
  EXPECT_NEAR(sut.pose().heading_rad, 0, 1e-9);
  EXPECT_NEAR(sut.pose().x_m, 1000 * tick_m, 1e-9);
  EXPECT_NEAR(sut.pose().y_m, 0, 1e-9);
  EXPECT_EQ(sut.rejected_jumps(), 1U);
}

TEST(Odometry, UndoesNothingForASampleThatIsLongAfterwards) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), {});
  sut.update(core(60, 500, 500), {});
  sut.update(core(201, 900, 900), {});
  sut.update(core(221, 900, 900), {});    // confirms a pause
  sut.update(core(281, 10000, 900), {});  // damaged; 0.2 s after the last but one
  sut.update(core(301, 900, 900), {});
  EXPECT_NEAR(sut.pose().x_m, 900 * tick_m, 1e-9);
  sut.update(core(621, 6000, 900), {});  // damaged; possible after the last but one only
  EXPECT_NEAR(sut.pose().x_m, 900 * tick_m, 1e-9);
}

TEST(Odometry, IsNotRestartedByADamagedSampleAfterAGoodOne) {
  Odometry sut{by_encoder()};
  sut.update(core(0, 0, 0), {});
  sut.update(core(500, 8898, 8898), {});  // just possible
  sut.update(core(520, 9356, 9356), {});  // no more, but not far from the one before
  sut.update(core(540, 8950, 8950), {});
  EXPECT_NEAR(sut.pose().x_m, 8950 * tick_m, 1e-9);
}

TEST(Odometry, WaitsForTwoSamplesTogetherOnANoisyLine) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  for (int i = 1; i < 10; ++i) {
    sut.update(core(300 * i, 0, 0), inertia(i % 2 * 4000), 0.3 * i);
    EXPECT_TRUE(sut.waits());
  }
  sut.update(core(6000, 2000, 2000), inertia(0), 6);
  sut.update(core(6020, 2000, 2000), inertia(0), 6.02);
  EXPECT_FALSE(sut.waits());
  EXPECT_NEAR(sut.pose().x_m, 2000 * tick_m, 1e-9);
  EXPECT_EQ(sut.pose().heading_rad, 0);
}

TEST(Odometry, TakesAPauseForAnArc) {
  Odometry sut{OdometryParams{}};
  sut.update(core(0, 0, 0), inertia(0));
  for (int i = 0; i < 2; ++i) sut.update(core(2000, 10000, 10000), inertia(9000));
  const double radius_m = 10000 * tick_m / (pi / 2);
  EXPECT_NEAR(sut.pose().x_m, radius_m, 1e-6);
  EXPECT_NEAR(sut.pose().y_m, radius_m, 1e-6);
}

TEST(Odometry, TakesABaseWhoseClockDidNotGoOnInASilenceForARestartedOne) {
  EXPECT_GT(bridged(8, 8.27, 4000).x_m, 0.3);
  EXPECT_EQ(bridged(8, 8.31, 4000).x_m, 0);
  EXPECT_GT(bridged(8, 6.5, 4000).x_m, 0.3);  // the bytes waited for a second to be read
  EXPECT_EQ(bridged(8, 6.46, 4000).x_m, 0);
  EXPECT_EQ(bridged(8, 6.46, 4000).heading_rad, 0);
}

TEST(Odometry, TakesMoreThanABaseCanRollInASilenceForARestartedOne) {
  const int limit_ticks = static_cast<int>(1.2 / tick_m);
  EXPECT_GT(bridged(8, 8, limit_ticks).x_m, 1.19);
  EXPECT_EQ(bridged(8, 8, limit_ticks + 1).x_m, 0);
}

}  // namespace
}  // namespace tocsin::kobuki
