// SPDX-License-Identifier: Apache-2.0
#include "teleop_keyboard/keyboard_teleop.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);

KeyboardTeleop turtlebot() {
  KeyboardTeleop::Params params;
  params.layout = KeyLayout::turtlebot;
  return KeyboardTeleop(params);
}

void expect_velocity(KeyboardTeleop sut, const std::string& keys, double linear, double angular) {
  sut.on_bytes(keys, t0);
  EXPECT_DOUBLE_EQ(sut.velocity(t0).linear_mps, linear) << keys;
  EXPECT_DOUBLE_EQ(sut.velocity(t0).angular_rad_s, angular) << keys;
}

TEST(KeyboardTeleop, DrivesByTheLettersOfItsLayoutAndByArrows) {
  const auto drives_by = [](const KeyboardTeleop& sut, const std::vector<std::string>& keys) {
    expect_velocity(sut, keys[0], 0.3, 0);
    expect_velocity(sut, keys[1], -0.3, 0);
    expect_velocity(sut, keys[2], 0, 1);
    expect_velocity(sut, keys[3], 0, -1);
    if (keys.size() == 4) return;
    expect_velocity(sut, keys[4], 0.3, 1);
    expect_velocity(sut, keys[5], 0.3, -1);
    expect_velocity(sut, keys[6], -0.3, -1);
    expect_velocity(sut, keys[7], -0.3, 1);
  };
  const KeyboardTeleop wasd{KeyboardTeleop::Params{}};
  drives_by(wasd, {"w", "s", "a", "d", "q", "e", "z", "c"});
  drives_by(wasd, {"W", "S", "A", "D"});
  drives_by(turtlebot(), {"i", ",", "j", "l", "u", "o", "m", "."});
  expect_velocity(turtlebot(), "ik", 0, 0);
  for (const KeyboardTeleop& sut : {wasd, turtlebot()}) {
    drives_by(sut, {"\x1b[A", "\x1b[B", "\x1b[D", "\x1b[C"});
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
  sut.on_bytes("w-", t0);
  EXPECT_DOUBLE_EQ(sut.velocity(t0).linear_mps, 0.7 / 1.1) << "a step does not stop";
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
