// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/devices.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RealDevicesTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  Devices& sut_ = real_devices();
};

TEST_F(RealDevicesTest, ReadTheTextOfAFile) {
  EXPECT_EQ(sut_.read_text(folder_.write("temp", "47250\n")), "47250\n");
  EXPECT_THAT(sut_.read_text("/proc/stat").value_or(""), HasSubstr("cpu"));
}

TEST_F(RealDevicesTest, HaveNoTextOfAnAbsentOrEmptyFileOrAFolder) {
  EXPECT_FALSE(sut_.read_text(folder_.path("absent")));
  EXPECT_FALSE(sut_.read_text(folder_.write("empty", "")));
  EXPECT_FALSE(sut_.read_text(folder_.path()));
}

TEST_F(RealDevicesTest, ListAFolderInOrder) {
  for (const char* name : {"zone1", "cooling0", "zone0"}) (void)folder_.write(name, "x");
  EXPECT_THAT(sut_.list_folder(folder_.path()), ElementsAre("cooling0", "zone0", "zone1"));
  EXPECT_TRUE(sut_.list_folder(folder_.path("absent")).empty());
}

TEST_F(RealDevicesTest, SayWhyAPortIsAbsent) {
  const OpenedSerial serial = sut_.open_serial(folder_.path("absent"), [] {});
  EXPECT_EQ(serial.result, OpenedSerial::Result::absent);
  EXPECT_THAT(serial.reason, HasSubstr("absent: No such file"));
}

TEST_F(RealDevicesTest, RefuseAnEchoTargetThatIsNoAddress) {
  EXPECT_THROW((void)sut_.open_echo({"nowhere", 64}, [] {}), ConfigError);
}

TEST_F(RealDevicesTest, ReadTheRadioFromAFileTheKernelKnowsNothingAbout) {
  const auto file = folder_.write("wireless", "    lo: 0000 30. -80. -94. 0 0 0 0 0 0\n");
  EXPECT_EQ(sut_.open_wireless("lo", file)->read().signal_dbm, -80.0);
}

TEST_F(RealDevicesTest, HaveNoGamepadAtAPathThatIsNone) {
  EXPECT_EQ(sut_.open_gamepad("/dev/null"), nullptr);
}

TEST_F(RealDevicesTest, AreThoseOfAComputerThatCrashesAndIsLookedAt) {
  EXPECT_TRUE(sut_.keeps_files());
  EXPECT_TRUE(sut_.has_spectators());
}

}  // namespace
}  // namespace tocsin
