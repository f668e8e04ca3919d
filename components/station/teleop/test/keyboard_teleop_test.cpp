// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/keyboard_teleop.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);

KeyboardTeleop turtlebot() {
  KeyboardTeleop::Params params;
  params.layout = "turtlebot";
  return KeyboardTeleop(params);
}

void expect_velocity(KeyboardTeleop sut, const char* key, double linear, double angular) {
  sut.on_bytes(key, t0);
  EXPECT_DOUBLE_EQ(sut.velocity(t0).linear_mps, linear) << key;
  EXPECT_DOUBLE_EQ(sut.velocity(t0).angular_rad_s, angular) << key;
}

TEST(KeyboardTeleop, DrivesByWasd) {
  const KeyboardTeleop sut{KeyboardTeleop::Params{}};
  expect_velocity(sut, "w", 0.3, 0);
  expect_velocity(sut, "s", -0.3, 0);
  expect_velocity(sut, "a", 0, 1);
  expect_velocity(sut, "d", 0, -1);
  expect_velocity(sut, "q", 0.3, 1);
  expect_velocity(sut, "e", 0.3, -1);
  expect_velocity(sut, "z", -0.3, -1);
  expect_velocity(sut, "c", -0.3, 1);
  expect_velocity(sut, "W", 0.3, 0);
}

TEST(KeyboardTeleop, DrivesByTheTurtlebotLayout) {
  expect_velocity(turtlebot(), "i", 0.3, 0);
  expect_velocity(turtlebot(), ",", -0.3, 0);
  expect_velocity(turtlebot(), "j", 0, 1);
  expect_velocity(turtlebot(), "l", 0, -1);
  expect_velocity(turtlebot(), "u", 0.3, 1);
  expect_velocity(turtlebot(), "o", 0.3, -1);
  expect_velocity(turtlebot(), "m", -0.3, -1);
  expect_velocity(turtlebot(), ".", -0.3, 1);
  expect_velocity(turtlebot(), "ik", 0, 0);
}

TEST(KeyboardTeleop, DrivesByArrowsInBothLayouts) {
  for (const KeyboardTeleop& sut : {KeyboardTeleop{KeyboardTeleop::Params{}}, turtlebot()}) {
    expect_velocity(sut, "\x1b[A", 0.3, 0);
    expect_velocity(sut, "\x1b[B", -0.3, 0);
    expect_velocity(sut, "\x1b[D", 0, 1);
    expect_velocity(sut, "\x1b[C", 0, -1);
  }
}

TEST(KeyboardTeleop, SpaceAndUnknownKeysStop) {
  const KeyboardTeleop sut{KeyboardTeleop::Params{}};
  expect_velocity(sut, "w ", 0, 0);
  expect_velocity(sut, "wy", 0, 0);
  expect_velocity(sut, "w\x1b[15~", 0, 0);
}

TEST(KeyboardTeleop, APressLastsUntilTheRepeatDelayIsOver) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("w", t0);
  EXPECT_EQ(sut.next_deadline(t0), t0 + seconds(0.7));
  EXPECT_GT(sut.velocity(t0 + seconds(0.699)).linear_mps, 0);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.7)).linear_mps, 0);
  EXPECT_EQ(sut.next_deadline(t0 + seconds(0.7)), never);
}

TEST(KeyboardTeleop, ARepeatLastsUntilTheNextIsOverdue) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("w", t0);
  sut.on_bytes("w", t0 + seconds(0.6));
  EXPECT_GT(sut.velocity(t0 + seconds(0.849)).linear_mps, 0);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.85)).linear_mps, 0);
}

TEST(KeyboardTeleop, ANewPressAfterAReleaseLastsTheWholeDelayAgain) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("ww", t0);
  sut.on_bytes("w", t0 + seconds(1));
  EXPECT_GT(sut.velocity(t0 + seconds(1.69)).linear_mps, 0);
}

TEST(KeyboardTeleop, AnotherKeyTakesOverAtOnce) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("w", t0);
  sut.on_bytes("a", t0 + seconds(0.1));
  EXPECT_EQ(sut.velocity(t0 + seconds(0.1)).linear_mps, 0);
  EXPECT_EQ(sut.velocity(t0 + seconds(0.1)).angular_rad_s, 1);
}

TEST(KeyboardTeleop, StepsTheSpeedsWithinTheirLimits) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("r", t0);
  EXPECT_DOUBLE_EQ(sut.linear_mps(), 0.33);
  EXPECT_DOUBLE_EQ(sut.angular_rad_s(), 1);
  sut.on_bytes("g", t0);
  EXPECT_DOUBLE_EQ(sut.angular_rad_s(), 1 / 1.1);
  sut.on_bytes("++++++++++++++++++++++", t0);
  EXPECT_EQ(sut.linear_mps(), 0.7);
  EXPECT_EQ(sut.angular_rad_s(), 1.9);
}

TEST(KeyboardTeleop, AStepOfSpeedDoesNotStop) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("w+", t0);
  EXPECT_DOUBLE_EQ(sut.velocity(t0).linear_mps, 0.33);
}

TEST(KeyboardTeleop, TurtlebotStepsByItsOwnKeys) {
  KeyboardTeleop sut = turtlebot();
  sut.on_bytes("qwe", t0);
  EXPECT_DOUBLE_EQ(sut.linear_mps(), 0.3 * 1.1 * 1.1);
  EXPECT_DOUBLE_EQ(sut.angular_rad_s(), 1.1 * 1.1);
}

TEST(KeyboardTeleop, StandsWhenTheTerminalIsGone) {
  KeyboardTeleop sut{KeyboardTeleop::Params{}};
  sut.on_bytes("w", t0);
  sut.on_end();
  EXPECT_EQ(sut.velocity(t0).linear_mps, 0);
}

TEST(KeyboardTeleop, RefusesASpeedAboveItsLimit) {
  KeyboardTeleop::Params params;
  params.linear_mps = 0.8;
  EXPECT_THROW(KeyboardTeleop{params}, ConfigError);
}

}  // namespace
}  // namespace tocsin
