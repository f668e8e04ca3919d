// SPDX-License-Identifier: Apache-2.0
/// A virtual pad of the kernel, where /dev/uinput may be used.
#include <gtest/gtest.h>
#include <libevdev/libevdev-uinput.h>
#include <libevdev/libevdev.h>

#include <memory>
#include <thread>

#include "evdev_gamepad.hpp"

namespace tocsin {
namespace {

struct Destroy {
  void operator()(libevdev_uinput* pad) const { libevdev_uinput_destroy(pad); }
};
using VirtualPad = std::unique_ptr<libevdev_uinput, Destroy>;

/// Null where virtual devices are not allowed.
VirtualPad make_pad() {
  libevdev* device = libevdev_new();
  libevdev_set_name(device, "Tocsin test pad");
  const input_absinfo range{128, 0, 255, 0, 0, 0};
  for (const unsigned axis : {ABS_X, ABS_Y})
    libevdev_enable_event_code(device, EV_ABS, axis, &range);
  for (const unsigned key : {BTN_SOUTH, BTN_TL}) {
    libevdev_enable_event_code(device, EV_KEY, key, nullptr);
  }
  libevdev_uinput* pad = nullptr;
  const int result = libevdev_uinput_create_from_device(device, LIBEVDEV_UINPUT_OPEN_MANAGED, &pad);
  libevdev_free(device);
  return VirtualPad(result == 0 ? pad : nullptr);
}

GamepadDevice::Read read_soon(GamepadDevice& sut, PadEvent& event) {
  for (int i = 0; i < 2000; ++i) {
    const auto result = sut.read(event);
    if (result != GamepadDevice::Read::nothing) return result;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return GamepadDevice::Read::nothing;
}

TEST(EvdevGamepad, AbsentDeviceIsNoGamepad) {
  EXPECT_EQ(open_evdev_gamepad("/nowhere/event0"), nullptr);
  EXPECT_EQ(open_evdev_gamepad("/dev/null"), nullptr);
}

TEST(EvdevGamepad, ReadsAVirtualPadUntilItIsPulled) {
  VirtualPad pad = make_pad();
  if (!pad) GTEST_SKIP() << "no virtual input devices here (/dev/uinput)";
  const auto sut = open_evdev_gamepad(libevdev_uinput_get_devnode(pad.get()));
  ASSERT_NE(sut, nullptr);
  EXPECT_EQ(sut->name(), "Tocsin test pad");
  EXPECT_EQ(sut->axes().at(ABS_Y).max, 255);
  PadEvent event;
  EXPECT_EQ(sut->read(event), GamepadDevice::Read::nothing);
  libevdev_uinput_write_event(pad.get(), EV_KEY, BTN_TL, 1);
  libevdev_uinput_write_event(pad.get(), EV_SYN, SYN_REPORT, 0);
  ASSERT_EQ(read_soon(*sut, event), GamepadDevice::Read::event);
  EXPECT_EQ(event.code, BTN_TL);
  ASSERT_EQ(read_soon(*sut, event), GamepadDevice::Read::event);  // the report
  pad.reset();
  EXPECT_EQ(read_soon(*sut, event), GamepadDevice::Read::lost);
}

}  // namespace
}  // namespace tocsin
