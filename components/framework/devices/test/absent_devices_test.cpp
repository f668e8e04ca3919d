// SPDX-License-Identifier: Apache-2.0
#include "devices/absent_devices.hpp"

#include <gtest/gtest.h>

#include <cerrno>

namespace tocsin {
namespace {

class AbsentDevicesTest : public ::testing::Test {
 protected:
  AbsentDevices sut_;
};

TEST_F(AbsentDevicesTest, HaveNothingToOpen) {
  const OpenedSerial serial = sut_.open_serial("/dev/kobuki", [] {});
  EXPECT_EQ(serial.result, OpenedSerial::Result::absent);
  EXPECT_EQ(serial.port, nullptr);
  EXPECT_EQ(serial.reason, "/dev/kobuki: no such device");
  EXPECT_EQ(sut_.open_gamepad(""), nullptr);
  EXPECT_EQ(sut_.open_terminal(), nullptr);
}

TEST_F(AbsentDevicesTest, RefuseEchoRequests) {
  const auto echo = sut_.open_echo({"127.0.0.1", 64}, [] {});
  EXPECT_EQ(echo->send(1).error, ENETUNREACH);
  EXPECT_FALSE(echo->receive());
  EXPECT_FALSE(echo->descriptor());
}

TEST_F(AbsentDevicesTest, SayThatThereIsNoRadio) {
  const auto reading = sut_.open_wireless("wlan0", "/proc/net/wireless")->read();
  EXPECT_EQ(reading.source, network::WirelessSource::absent);
  EXPECT_EQ(reading.note, "this computer has no wireless interface");
}

TEST_F(AbsentDevicesTest, DoBackgroundWorkAtOnce) {
  bool done = false;
  const auto background = sut_.open_background();
  background->post([&] { done = true; });
  EXPECT_TRUE(done);
  EXPECT_EQ(background->waiting(), 0U);
}

TEST_F(AbsentDevicesTest, HaveNoFiles) {
  EXPECT_FALSE(sut_.read_text("/proc/stat"));
  EXPECT_TRUE(sut_.list_folder("/").empty());
  EXPECT_FALSE(sut_.keeps_files());
  EXPECT_FALSE(sut_.has_spectators());
}

}  // namespace
}  // namespace tocsin
