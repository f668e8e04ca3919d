// SPDX-License-Identifier: Apache-2.0
#include "teleop_gamepad/gamepad_teleop.hpp"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <vector>

namespace tocsin {
namespace {

constexpr std::uint16_t old_l1 = 0x12a;
const PadAxes ps3_axes{{ABS_X, {0, 255}}, {ABS_Y, {0, 255}}, {ABS_RX, {0, 255}}};
const PadAxes xbox_axes{
    {ABS_X, {-32768, 32767}}, {ABS_Y, {-32768, 32767}}, {ABS_HAT0X, {-1, 1}}, {ABS_HAT0Y, {-1, 1}}};

GamepadTeleop pad(PadLayout layout, const PadAxes& axes) {
  GamepadTeleop::Params params;
  params.layout = layout;
  GamepadTeleop sut(params);
  sut.on_connect(axes);
  return sut;
}

void feed(GamepadTeleop& sut, const std::vector<PadEvent>& events) {
  for (const PadEvent& event : events) sut.on_event(event);
}

// Events in the order and form in which a PlayStation 3 pad gives them under Linux 6.1: L1, the
// stick on its way to the top, a resting right stick that trembles.
const std::vector<PadEvent> l1_and_stick_up{
    {EV_KEY, BTN_TL, 1},   {EV_SYN, SYN_REPORT, 0}, {EV_ABS, ABS_Y, 96},
    {EV_ABS, ABS_RX, 129}, {EV_SYN, SYN_REPORT, 0}, {EV_ABS, ABS_Y, 31},
    {EV_ABS, ABS_X, 126},  {EV_SYN, SYN_REPORT, 0}, {EV_ABS, ABS_Y, 0},
    {EV_ABS, ABS_RX, 127}, {EV_SYN, SYN_REPORT, 0}};

TEST(GamepadTeleop, DrivesAPs3PadByTheLeftStickWhileL1IsHeld) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, l1_and_stick_up);
  EXPECT_DOUBLE_EQ(sut.velocity().linear_mps, 0.5);
  EXPECT_EQ(sut.velocity().angular_rad_s, 0);
  feed(sut, {{EV_ABS, ABS_Y, 128}, {EV_ABS, ABS_X, 0}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
  EXPECT_DOUBLE_EQ(sut.velocity().angular_rad_s, 1.5);
}

TEST(GamepadTeleop, StopsWhenTheDeadManButtonIsReleased) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, l1_and_stick_up);
  feed(sut, {{EV_KEY, BTN_TL, 2}});
  EXPECT_GT(sut.velocity().linear_mps, 0);
  feed(sut, {{EV_KEY, BTN_TL, 0}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
}

TEST(GamepadTeleop, DoesNothingWithoutTheDeadManButton) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, {{EV_ABS, ABS_Y, 0}, {EV_KEY, BTN_SOUTH, 1}, {EV_KEY, BTN_TR, 1}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
}

TEST(GamepadTeleop, KnowsL1OfOldKernels) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, {{EV_KEY, old_l1, 1}, {EV_ABS, ABS_Y, 255}});
  EXPECT_DOUBLE_EQ(sut.velocity().linear_mps, -0.5);
}

TEST(GamepadTeleop, RestsInTheDeadZoneAndGrowsFromZeroBeyondIt) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, {{EV_KEY, BTN_TL, 1}, {EV_ABS, ABS_Y, 113}});  // 0.114 of the way
  EXPECT_EQ(sut.velocity().linear_mps, 0);
  feed(sut, {{EV_ABS, ABS_Y, 112}});  // 0.122
  EXPECT_GT(sut.velocity().linear_mps, 0);
  EXPECT_LT(sut.velocity().linear_mps, 0.005);
}

TEST(GamepadTeleop, DrivesAGenericPadByStickOrCross) {
  for (const std::uint16_t shoulder : {std::uint16_t{BTN_TL}, std::uint16_t{BTN_TR}}) {
    GamepadTeleop sut = pad(PadLayout::generic, xbox_axes);
    feed(sut, {{EV_KEY, shoulder, 1}, {EV_ABS, ABS_Y, -32768}});
    EXPECT_DOUBLE_EQ(sut.velocity().linear_mps, 0.5);
    feed(sut, {{EV_ABS, ABS_Y, 0}, {EV_ABS, ABS_HAT0X, 1}});
    EXPECT_DOUBLE_EQ(sut.velocity().angular_rad_s, -1.5);
  }
}

TEST(GamepadTeleop, TheButtonMustBePressedAnewAfterAReconnection) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, l1_and_stick_up);
  sut.on_disconnect();
  EXPECT_EQ(sut.velocity().linear_mps, 0);
  sut.on_connect(ps3_axes);
  feed(sut, {{EV_ABS, ABS_Y, 0}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
}

TEST(GamepadTeleop, TheButtonCountsAsReleasedWhenEventsWereLost) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, l1_and_stick_up);
  feed(sut, {{EV_SYN, SYN_DROPPED, 0}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
}

TEST(GamepadTeleop, LivesWithAnAxisWithoutRangeAndWithoutAnyAxis) {
  GamepadTeleop sut = pad(PadLayout::ps3, {{ABS_Y, {5, 5}}});
  feed(sut, {{EV_KEY, BTN_TL, 1}, {EV_ABS, ABS_Y, 0}, {EV_ABS, ABS_X, 0}});
  EXPECT_EQ(sut.velocity().linear_mps, 0);
  EXPECT_EQ(sut.velocity().angular_rad_s, 0);
}

TEST(GamepadTeleop, IsNeverFasterThanItsLimits) {
  GamepadTeleop sut = pad(PadLayout::ps3, ps3_axes);
  feed(sut, {{EV_KEY, BTN_TL, 1}, {EV_ABS, ABS_Y, -100'000}});
  EXPECT_DOUBLE_EQ(sut.velocity().linear_mps, 0.5);
}

}  // namespace
}  // namespace tocsin
