// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/drive.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

ModelParams quick() {
  ModelParams params;
  params.command_delay_s = 0;
  params.acceleration_mps2 = 20;
  return params;
}

TEST(Drive, ObeysEachCommandAfterTheDeadTime) {
  ModelParams params = quick();
  params.command_delay_s = 0.2;
  Drive sut{params};
  sut.command({300, 0}, t0);
  sut.command({0, 0}, t0 + seconds(0.01));
  for (const auto& [at_s, speed_mps] : {std::pair(0.199, 0.0), {0.2, 0.3}, {0.21, 0.0}}) {
    sut.step(t0 + seconds(at_s), 1.0);
    EXPECT_DOUBLE_EQ(sut.speeds().left_mps, speed_mps) << at_s;
  }
  sut.command({300, 0}, t0);
  sut.reset();
  sut.step(t0 + seconds(1), 1.0);
  EXPECT_EQ(sut.speeds().left_mps, 0);
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

WheelSpeeds end_of(std::int16_t speed_mm_s, std::int16_t radius_mm) {
  Drive sut{quick()};
  sut.command({speed_mm_s, radius_mm}, t0);
  sut.step(t0, 100);
  return sut.speeds();
}

TEST(Drive, EndsAtTheSpeedOfTheSpecification) {
  EXPECT_DOUBLE_EQ(end_of(700, 0).left_mps, 0.7);
  EXPECT_DOUBLE_EQ(end_of(701, 0).left_mps, 0.7);
  EXPECT_DOUBLE_EQ(end_of(-32768, 0).right_mps, -0.7);
}

TEST(Drive, EndsAtTheTurnRateOfTheSpecification) {
  EXPECT_NEAR(body_velocity(end_of(361, 1)).angular_rad_s, 0.361 / 0.115, 1e-9);
  EXPECT_NEAR(body_velocity(end_of(362, 1)).angular_rad_s, pi, 1e-9);
  EXPECT_NEAR(body_velocity(end_of(-32768, 1)).angular_rad_s, -pi, 1e-9);
}

TEST(Drive, KeepsTheRadiusAtItsLimits) {
  const geometry::Twist fast = body_velocity(end_of(1400, 500));
  EXPECT_NEAR(fast.linear_mps / fast.angular_rad_s, 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(end_of(1400, 500).right_mps, 0.7);
  const geometry::Twist tight = body_velocity(end_of(690, 50));
  EXPECT_NEAR(tight.linear_mps / tight.angular_rad_s, 0.05, 1e-9);
  EXPECT_NEAR(tight.angular_rad_s, pi, 1e-9);
}

TEST(Drive, BoundsItsQueue) {
  ModelParams params = quick();
  params.command_delay_s = 1;
  Drive sut{params};
  for (int i = 0; i < 100000; ++i) sut.command({static_cast<std::int16_t>(i % 300), 0}, t0);
  sut.step(t0 + seconds(1), 1.0);
  EXPECT_DOUBLE_EQ(sut.target().left_mps, 0.099);  // the newest counts
}

TEST(Drive, RollsTheMeanOfRampAndSteadyPart) {
  ModelParams params = quick();
  params.acceleration_mps2 = 2;
  Drive sut{params};
  sut.command({200, 0}, t0);
  const WheelSpeeds ramp = sut.step(t0, 0.05);
  EXPECT_DOUBLE_EQ(ramp.left_mps, 0.05);  // from 0 to 0.1
  const WheelSpeeds both = sut.step(t0 + seconds(0.05), 0.1);
  EXPECT_DOUBLE_EQ(both.left_mps, (0.05 * 0.15 + 0.05 * 0.2) / 0.1);
  EXPECT_DOUBLE_EQ(sut.step(t0 + seconds(0.15), 0.1).left_mps, 0.2);
}

TEST(Drive, RollsAsFarInOneStepAsInMany) {
  ModelParams params = quick();
  params.acceleration_mps2 = 1.5;
  Drive one{params};
  Drive many{params};
  for (Drive* sut : {&one, &many}) sut->command({-31, 0}, t0);
  double way_m = 0;
  for (int i = 0; i < 40; ++i) {
    way_m += many.step(t0 + i * std::chrono::milliseconds(1), 0.001).left_mps * 0.001;
  }
  EXPECT_NEAR(one.step(t0, 0.04).left_mps * 0.04, way_m, 1e-12);
  EXPECT_DOUBLE_EQ(one.speeds().left_mps, many.speeds().left_mps);
}

TEST(Drive, KnowsWhenItsTargetChanges) {
  ModelParams params = quick();
  params.command_delay_s = 0.1;
  params.command_timeout_s = 0.5;
  Drive sut{params};
  EXPECT_EQ(sut.next_change(t0), never);
  sut.command({300, 0}, t0);
  sut.command({200, 0}, t0 + seconds(0.02));
  EXPECT_EQ(sut.next_change(t0), t0 + seconds(0.1));
  EXPECT_EQ(sut.next_change(t0 + seconds(0.1)), t0 + seconds(0.12));
  EXPECT_EQ(sut.next_change(t0 + seconds(0.12)), t0 + seconds(0.52) + Duration{1});
  EXPECT_EQ(sut.next_change(t0 + seconds(1)), never);
}

TEST(Drive, HasNoChangeForARepeatedCommandWhichStillKeepsItDriving) {
  ModelParams params = quick();
  params.command_delay_s = 0.1;
  params.command_timeout_s = 0.5;
  Drive sut{params};
  sut.command({300, 0}, t0);
  sut.step(t0 + seconds(0.1), 0.1);
  sut.command({300, 0}, t0 + seconds(0.2));
  EXPECT_EQ(sut.next_change(t0 + seconds(0.2)), t0 + seconds(0.7) + Duration{1});
  sut.step(t0 + seconds(0.6), 0.1);
  EXPECT_DOUBLE_EQ(sut.speeds().left_mps, 0.3);
}

}  // namespace
}  // namespace tocsin::kobuki
