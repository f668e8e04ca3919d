// SPDX-License-Identifier: Apache-2.0
#include "devices/devices.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "devices/computer.hpp"
#include "devices/device_files.hpp"
#include "devices/echo_device.hpp"
#include "devices/gamepad_device.hpp"
#include "devices/serial_device.hpp"
#include "devices/terminal_device.hpp"
#include "devices/wireless.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using network::WirelessDevice;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A kind of device that this package has never heard of.
struct Imu : Device {
  static constexpr const char* kind = "IMU";
  [[nodiscard]] virtual double turn_rate() const { return 0; }
};

struct TurningImu final : Imu {
  [[nodiscard]] double turn_rate() const override { return 3; }
};

Opened<Imu> make_turning(const std::string& path, const Devices::Readable& /*readable*/) {
  if (path != "/dev/imu") return {};
  return std::make_unique<TurningImu>();
}

/// What opening throws.
std::string refusal(const Devices& devices, const std::string& path) {
  try {
    (void)devices.open<Imu>(path);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Devices, OpenWhatAMakerWasAddedFor) {
  Devices sut;
  sut.add<Imu>(make_turning);
  EXPECT_EQ(sut.open<Imu>("/dev/imu")->turn_rate(), 3);
}

TEST(Devices, NameKindAndPathOfWhatIsAbsent) {
  Devices sut;
  EXPECT_EQ(refusal(sut, "/dev/imu"), "IMU /dev/imu: no such device") << "no maker";
  sut.add<Imu>(make_turning);
  EXPECT_EQ(refusal(sut, "/dev/other"), "IMU /dev/other: no such device") << "no device";
}

TEST(Devices, TellWhyOneThatMayComeLaterIsAbsent) {
  const Devices sut;
  const OpenedSerial serial = sut.try_open<SerialDevice>("/dev/kobuki");
  EXPECT_EQ(serial.result, OpenedSerial::Result::absent);
  EXPECT_EQ(serial.device, nullptr);
  EXPECT_EQ(serial.reason, "/dev/kobuki: no such device");
}

TEST(Devices, AreSilentWhereAskedToBe) {
  const Devices sut(Devices::Unknown::silent);
  EXPECT_EQ(sut.open<Imu>("/dev/imu")->turn_rate(), 0);
  EXPECT_EQ(sut.open<SerialDevice>("/dev/x")->read(nullptr, 0), 0U);
  EXPECT_EQ(sut.open<EchoDevice>()->send(1).error, ENETUNREACH);
  EXPECT_FALSE(sut.open<EchoDevice>()->receive());
  EXPECT_EQ(sut.open<WirelessDevice>()->read().source, network::WirelessSource::absent);
  PadEvent event;
  EXPECT_EQ(sut.open<GamepadDevice>()->read(event), GamepadDevice::Read::nothing);
  EXPECT_FALSE(sut.open<TerminalDevice>()->read());
  EXPECT_FALSE(sut.open<DeviceFiles>()->read("/proc/stat"));
}

TEST(Computer, HasNothingUnlessTold) {
  const Computer sut;
  EXPECT_FALSE(sut.keeps_files);
  EXPECT_FALSE(sut.has_spectators);
  bool done = false;
  const auto background = sut.open_background();
  background->post([&] { done = true; });
  EXPECT_TRUE(done);
  EXPECT_EQ(background->waiting(), 0U);
}

class ThisComputerTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  Devices& sut_ = this_computer().devices;
  std::unique_ptr<DeviceFiles> files_ = sut_.open<DeviceFiles>();
};

TEST_F(ThisComputerTest, ReadsTheTextOfAFile) {
  EXPECT_EQ(files_->read(folder_.write("temp", "47250\n")), "47250\n");
  EXPECT_THAT(files_->read("/proc/stat").value_or(""), HasSubstr("cpu"));
}

TEST_F(ThisComputerTest, HasNoTextOfAnAbsentOrEmptyFileOrAFolder) {
  for (const auto& path :
       {folder_.path("absent"), folder_.write("empty", ""), std::string(folder_.path())}) {
    EXPECT_FALSE(files_->read(path)) << path;
  }
}

TEST_F(ThisComputerTest, ListsAFolderInOrder) {
  for (const char* name : {"zone1", "cooling0", "zone0"}) (void)folder_.write(name, "x");
  EXPECT_THAT(files_->list(folder_.path()), ElementsAre("cooling0", "zone0", "zone1"));
  EXPECT_TRUE(files_->list(folder_.path("absent")).empty());
}

TEST_F(ThisComputerTest, SaysWhyAPortIsAbsent) {
  const OpenedSerial serial = sut_.try_open<SerialDevice>(folder_.path("absent"));
  EXPECT_EQ(serial.result, OpenedSerial::Result::absent);
  EXPECT_THAT(serial.reason, HasSubstr("absent: No such file"));
}

TEST_F(ThisComputerTest, RefusesAnEchoTargetThatIsNoAddress) {
  EXPECT_THROW((void)sut_.open<EchoDevice>({"nowhere", 64}), ConfigError);
}

TEST_F(ThisComputerTest, ReadsTheRadioFromAFileTheKernelKnowsNothingAbout) {
  const auto file = folder_.write("wireless", "    lo: 0000 30. -80. -94. 0 0 0 0 0 0\n");
  EXPECT_EQ(sut_.open<WirelessDevice>({"lo", file})->read().signal_dbm, -80.0);
}

TEST_F(ThisComputerTest, HasNoGamepadAtAPathThatIsNone) {
  EXPECT_EQ(sut_.try_open<GamepadDevice>("/dev/null").device, nullptr);
}

TEST_F(ThisComputerTest, CrashesAndIsLookedAt) {
  EXPECT_TRUE(this_computer().keeps_files);
  EXPECT_TRUE(this_computer().has_spectators);
}

}  // namespace
}  // namespace tocsin
