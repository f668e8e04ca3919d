// SPDX-License-Identifier: Apache-2.0
#include "safety_controller/safety_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin {
namespace {

using kobuki::centre_bit;
using kobuki::left_bit;
using kobuki::right_bit;

const Time t0 = Time{} + seconds(100);

geometry::Twist reaction(const Hazards& hazards) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_hazards(hazards, t0);
  return sut.on_wanted({0.5, 0.5}, t0);
}

SafetyController stop_only() {
  SafetyController::Params params;
  params.stop_only = true;
  return SafetyController(params);
}

TEST(SafetyController, BacksOffInTheOrderOfTheReference) {
  EXPECT_EQ(reaction({centre_bit, 0, 0}).linear_mps, -0.1);
  EXPECT_EQ(reaction({centre_bit | left_bit, 0, 0}).angular_rad_s, 0);
  EXPECT_EQ(reaction({0, left_bit, 0}).angular_rad_s, -0.4);
  EXPECT_EQ(reaction({left_bit | right_bit, 0, 0}).angular_rad_s, -0.4);
  EXPECT_EQ(reaction({right_bit, 0, 0}).angular_rad_s, 0.4);
  EXPECT_EQ(reaction({centre_bit, centre_bit, 1}).linear_mps, 0);  // wheel drop first
}

TEST(SafetyController, BacksOffWithoutAnyWishAndRepeatsIt) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_hazards({centre_bit, 0, 0}, t0);
  EXPECT_EQ(sut.update(t0)->linear_mps, -0.1);
  EXPECT_EQ(sut.next_deadline(t0), t0 + seconds(0.1));
  EXPECT_FALSE(sut.update(t0 + seconds(0.099)));
  EXPECT_TRUE(sut.update(t0 + seconds(0.1)));
}

TEST(SafetyController, StandsWhenTheHazardHasGoneUntilANewWish) {
  SafetyController sut{SafetyController::Params{}};
  (void)sut.on_wanted({0.3, 0}, t0);
  sut.on_hazards({left_bit, 0, 0}, t0);
  ASSERT_TRUE(sut.update(t0));
  sut.on_hazards({}, t0 + seconds(0.02));
  EXPECT_EQ(sut.update(t0 + seconds(0.02))->linear_mps, 0);
  EXPECT_FALSE(sut.update(t0 + seconds(0.03)));
  EXPECT_EQ(sut.on_wanted({0.3, 0}, t0 + seconds(0.05)).linear_mps, 0.3);
}

TEST(SafetyController, ExtendsAHazard) {
  SafetyController::Params params;
  params.time_to_extend_s = 0.5;
  SafetyController sut{params};
  sut.on_hazards({left_bit, 0, 0}, t0);
  sut.on_hazards({}, t0 + seconds(0.1));
  EXPECT_EQ(sut.on_wanted({0.3, 0}, t0 + seconds(0.599)).linear_mps, -0.1);
  EXPECT_EQ(sut.on_wanted({0.3, 0}, t0 + seconds(0.6)).linear_mps, 0.3);
}

TEST(SafetyController, BacksOffFromOneHazardForALimitedTime) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_hazards({centre_bit, 0, 0}, t0);
  EXPECT_EQ(sut.on_wanted({0.3, 0.2}, t0 + seconds(1.999)).linear_mps, -0.1);
  EXPECT_EQ(sut.update(t0 + seconds(2))->linear_mps, 0);
  EXPECT_EQ(sut.on_wanted({0.3, 0.2}, t0 + seconds(2)).linear_mps, 0);
  EXPECT_EQ(sut.on_wanted({-0.3, 0.2}, t0 + seconds(2)).linear_mps, -0.3);
}

TEST(SafetyController, OnlyStopsWhenAskedTo) {
  SafetyController sut = stop_only();
  sut.on_hazards({0, centre_bit, 0}, t0);
  EXPECT_FALSE(sut.update(t0));
  const geometry::Twist out = sut.on_wanted({0.3, 0.2}, t0);
  EXPECT_EQ(out.linear_mps, 0);
  EXPECT_EQ(out.angular_rad_s, 0.2);
  EXPECT_EQ(sut.on_wanted({-0.2, 0}, t0).linear_mps, -0.2);
}

TEST(SafetyController, AllowsNothingWithADroppedWheel) {
  SafetyController sut = stop_only();
  sut.on_hazards({0, 0, 2}, t0);
  EXPECT_EQ(sut.on_wanted({-0.2, 1}, t0).linear_mps, 0);
  EXPECT_EQ(sut.on_wanted({-0.2, 1}, t0).angular_rad_s, 0);
}

TEST(SafetyController, StandsAtOnceWhileTheEmergencyStopIsPressed) {
  SafetyController sut{SafetyController::Params{}};
  sut.set_enabled(false);
  (void)sut.on_wanted({0.5, 0}, t0);
  sut.on_emergency_stop(true);
  EXPECT_EQ(sut.update(t0)->linear_mps, 0);
  EXPECT_EQ(sut.on_wanted({0.5, 0}, t0 + seconds(100)).linear_mps, 0);
  sut.on_emergency_stop(false);
  EXPECT_FALSE(sut.update(t0 + seconds(101)));
  EXPECT_EQ(sut.on_wanted({0.5, 0}, t0 + seconds(101)).linear_mps, 0.5);
}

TEST(SafetyController, DoesNotBackOffDuringAnEmergencyStop) {
  SafetyController sut{SafetyController::Params{}};
  sut.on_emergency_stop(true);
  sut.on_hazards({centre_bit, 0, 0}, t0);
  EXPECT_EQ(sut.update(t0).value_or(geometry::Twist{}).linear_mps, 0);
}

TEST(SafetyController, StopsOnNumbersThatAreNone) {
  SafetyController sut{SafetyController::Params{}};
  EXPECT_EQ(sut.on_wanted({std::nan(""), 1}, t0).angular_rad_s, 0);
}

}  // namespace
}  // namespace tocsin
