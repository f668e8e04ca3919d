// SPDX-License-Identifier: Apache-2.0
#include "motion/safety_controller.hpp"

#include <gtest/gtest.h>

namespace tocsin::motion {
namespace {

using kobuki::centre_bit;
using kobuki::left_bit;
using kobuki::right_bit;

const Time t0 = Time{} + seconds(100);

BodyVelocity reaction(const Hazards& hazards) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_sensors(hazards, t0);
  return sut.override_velocity(t0).value_or(BodyVelocity{9, 9});
}

TEST(SafetyController, HasNothingToSayWhenAllIsWell) {
  SafetyController sut{SafetyController::Params{}};
  EXPECT_FALSE(sut.override_velocity(t0));
  sut.on_sensors({}, t0);
  EXPECT_FALSE(sut.override_velocity(t0));
  EXPECT_EQ(sut.filter({0.3, 0.1}, t0).linear_mps, 0.3);
}

TEST(SafetyController, BacksOffInTheOrderOfTheReference) {
  EXPECT_EQ(reaction({centre_bit, 0, 0}).linear_mps, -0.1);
  EXPECT_EQ(reaction({centre_bit | left_bit, 0, 0}).angular_rad_s, 0);
  EXPECT_EQ(reaction({0, left_bit, 0}).angular_rad_s, -0.4);
  EXPECT_EQ(reaction({left_bit | right_bit, 0, 0}).angular_rad_s, -0.4);
  EXPECT_EQ(reaction({right_bit, 0, 0}).angular_rad_s, 0.4);
  EXPECT_EQ(reaction({centre_bit, centre_bit, 1}).linear_mps, 0);  // wheel drop first
}

TEST(SafetyController, ExtendsAHazard) {
  SafetyController::Params params;
  params.time_to_extend_s = 0.5;
  SafetyController sut{params};
  sut.on_sensors({left_bit, 0, 0}, t0);
  sut.on_sensors({}, t0 + seconds(0.1));
  EXPECT_TRUE(sut.override_velocity(t0 + seconds(0.499)));
  EXPECT_FALSE(sut.override_velocity(t0 + seconds(0.5)));
}

TEST(SafetyController, EndsWithTheHazardByDefault) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_sensors({left_bit, 0, 0}, t0);
  sut.on_sensors({}, t0 + seconds(0.02));
  EXPECT_FALSE(sut.override_velocity(t0 + seconds(0.02)));
}

TEST(SafetyController, DoesNotBackOffBlindly) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_sensors({centre_bit, 0, 0}, t0);
  EXPECT_EQ(sut.override_velocity(t0 + seconds(0.5))->linear_mps, -0.1);
  EXPECT_EQ(sut.override_velocity(t0 + seconds(0.501))->linear_mps, 0);
}

TEST(SafetyController, OnlyStopsWhenAskedTo) {
  SafetyController::Params params;
  params.stop_only = true;
  SafetyController sut{params};
  sut.on_sensors({0, centre_bit, 0}, t0);
  EXPECT_FALSE(sut.override_velocity(t0));
  EXPECT_EQ(sut.filter({0.3, 0.2}, t0).linear_mps, 0);
  EXPECT_EQ(sut.filter({0.3, 0.2}, t0).angular_rad_s, 0.2);
  EXPECT_EQ(sut.filter({-0.2, 0}, t0).linear_mps, -0.2);
}

TEST(SafetyController, AllowsNothingWithADroppedWheel) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_sensors({0, 0, 2}, t0);
  EXPECT_EQ(sut.filter({-0.2, 1}, t0).linear_mps, 0);
  EXPECT_EQ(sut.filter({-0.2, 1}, t0).angular_rad_s, 0);
}

TEST(SafetyController, LetsEverythingPassWhenDisabled) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_sensors({centre_bit, 0, 1}, t0);
  sut.set_enabled(false);
  EXPECT_FALSE(sut.override_velocity(t0));
  EXPECT_EQ(sut.filter({0.3, 0}, t0).linear_mps, 0.3);
}

}  // namespace
}  // namespace tocsin::motion
