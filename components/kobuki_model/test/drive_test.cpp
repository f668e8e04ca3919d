// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/drive.hpp"

#include <gtest/gtest.h>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

ModelParams quick() {
  ModelParams params;
  params.command_delay_s = 0;
  params.acceleration_mps2 = 20;
  return params;
}

TEST(Drive, StandsStillWithoutCommands) {
  Drive sut{quick()};
  sut.step(t0, 1.0);
  EXPECT_EQ(sut.speeds().left_mps, 0);
}

TEST(Drive, ReachesTheCommandedSpeeds) {
  Drive sut{quick()};
  sut.command({345, 345}, t0);
  sut.step(t0, 1.0);
  EXPECT_DOUBLE_EQ(sut.speeds().right_mps, 0.345);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.1725);
}

TEST(Drive, LimitsTheAcceleration) {
  ModelParams params = quick();
  params.acceleration_mps2 = 0.5;
  Drive sut{params};
  sut.command({300, 0}, t0);
  sut.step(t0, 0.1);
  EXPECT_NEAR(sut.speeds().left_mps, 0.05, 1e-12);
  for (int i = 0; i < 10; ++i) sut.step(t0, 0.1);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.3);
}

TEST(Drive, ObeysAfterTheDeadTime) {
  ModelParams params = quick();
  params.command_delay_s = 0.2;
  Drive sut{params};
  sut.command({300, 0}, t0);
  sut.step(t0 + seconds(0.199), 1.0);
  EXPECT_EQ(sut.speeds().left_mps, 0);
  sut.step(t0 + seconds(0.2), 1.0);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.3);
}

TEST(Drive, DrivesForEverWithoutATimeout) {
  Drive sut{quick()};
  sut.command({300, 0}, t0);
  sut.step(t0 + seconds(3600), 1.0);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.3);
}

TEST(Drive, StopsOnlyAfterItsTimeout) {
  ModelParams params = quick();
  params.command_timeout_s = 0.5;
  Drive sut{params};
  sut.command({300, 0}, t0);
  sut.step(t0 + seconds(0.5), 1.0);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.3);
  sut.step(t0 + seconds(0.501), 1.0);
  EXPECT_EQ(sut.speeds().left_mps, 0);
}

TEST(Drive, LimitsTheSpeedToWhatTheMotorsCan) {
  Drive sut{quick()};
  sut.command({32767, 0}, t0);
  sut.step(t0, 100);
  EXPECT_LT(sut.speeds().left_mps, 1.1);
}

TEST(Drive, ForgetsEverythingWhenReset) {
  Drive sut{quick()};
  sut.command({300, 0}, t0);
  sut.reset();
  sut.step(t0, 1.0);
  EXPECT_EQ(sut.speeds().left_mps, 0);
}

TEST(Drive, BoundsItsQueue) {
  ModelParams params = quick();
  params.command_delay_s = 1;
  Drive sut{params};
  for (int i = 0; i < 100000; ++i) sut.command({static_cast<std::int16_t>(i % 300), 0}, t0);
  sut.step(t0 + seconds(1), 1.0);
  EXPECT_DOUBLE_EQ(sut.target().left_mps, 0.099);  // the newest counts
}

}  // namespace
}  // namespace tocsin::kobuki
