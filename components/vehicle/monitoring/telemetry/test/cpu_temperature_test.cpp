// SPDX-License-Identifier: Apache-2.0
#include "telemetry/cpu_temperature.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "devices/computer.hpp"

namespace tocsin::telemetry {
namespace {

using ::testing::Optional;

TEST(Temperature, IsInThousandthsOfADegreeWithinWhatACpuCanHave) {
  EXPECT_THAT(parse_temperature("47250\n"), Optional(47.25));
  EXPECT_THAT(parse_temperature("200000"), Optional(200.0));
  EXPECT_THAT(parse_temperature("-60000"), Optional(-60.0));
  for (const char* none : {"", "hot\n", "47250 x", "200001", "-60001"}) {
    EXPECT_FALSE(parse_temperature(none)) << none;
  }
}

TEST(CpuThermometer, PrefersThePackageToTheBoard) {
  const auto sut = choose_cpu_thermometer({{"acpitz", "a"}, {"nvme", "b"}, {"x86_pkg_temp", "c"}});
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->file, "c");
}

TEST(CpuThermometer, IsNotThatOfAnotherDevice) {
  EXPECT_FALSE(choose_cpu_thermometer({{"nvme", "a"}, {"iwlwifi_1", "b"}, {"battery", "c"}}));
  EXPECT_FALSE(choose_cpu_thermometer({}));
}

/// Folders in the form of /sys/class/thermal and /sys/class/hwmon, removed at the end.
class ThermometerListTest : public ::testing::Test {
 protected:
  ThermometerListTest() : root_("thermal_test_" + std::to_string(getpid())) {}
  ~ThermometerListTest() override { std::filesystem::remove_all(root_); }
  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  std::vector<Thermometer> list() const {
    const auto files = this_computer().devices.open<DeviceFiles>();
    return list_thermometers(*files, root_ / "thermal", root_ / "hwmon");
  }
  std::filesystem::path root_;
};

TEST_F(ThermometerListTest, FindsThermalZonesAndHardwareMonitors) {
  write("thermal/thermal_zone0/type", "cpu-thermal\n");
  write("thermal/thermal_zone0/temp", "40000\n");
  write("hwmon/hwmon3/name", "k10temp\n");
  write("hwmon/hwmon3/temp1_input", "50000\n");
  const auto sut = list();
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].name, "k10temp");
  EXPECT_EQ(sut[1].name, "cpu-thermal");
}

TEST_F(ThermometerListTest, PassesOverDevicesWithoutATemperature) {
  write("thermal/cooling_device0/type", "Processor\n");
  write("hwmon/hwmon0/name", "fan\n");
  EXPECT_TRUE(list().empty());
}

TEST_F(ThermometerListTest, IsEmptyWithoutTheFolders) { EXPECT_TRUE(list().empty()); }

}  // namespace
}  // namespace tocsin::telemetry
