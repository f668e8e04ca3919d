// SPDX-License-Identifier: Apache-2.0
#include "telemetry/telemetry_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "foundation/parameters.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;

class TelemetryTest : public ::testing::Test {
 protected:
  TelemetryTest() : root_("telemetry_test_" + std::to_string(getpid())) {
    write("meminfo", "MemTotal: 4000 kB\nMemAvailable: 1000 kB\n");
    write("stat", "cpu 100 0 0 100 0 0 0 0\ncpu0 100 0 0 100 0 0 0 0\n");
    write("thermal/thermal_zone0/type", "cpu-thermal\n");
    write("thermal/thermal_zone0/temp", "47250\n");
  }
  ~TelemetryTest() override { std::filesystem::remove_all(root_); }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  void start() {
    TelemetryComponent::Params params;
    params.meminfo_file = root_ / "meminfo";
    params.stat_file = root_ / "stat";
    params.thermal_dir = root_ / "thermal";
    params.hwmon_dir = root_ / "hwmon";
    sut_ = std::make_unique<TelemetryComponent>(context_, params);
    bus_.add(*sut_);
  }

  std::filesystem::path root_;
  SimBus bus_;
  Context context_{bus_, "telemetry", Role::uxv};
  SimReader<topic::MemoryUsage> memory_{bus_};
  SimReader<topic::CpuLoad> load_{bus_};
  SimReader<topic::CpuTemperature> temperature_{bus_};
  std::unique_ptr<TelemetryComponent> sut_;
};

TEST_F(TelemetryTest, ReportsMemoryAtStartAndEachSecond) {
  start();
  bus_.run_for(seconds(3.5));  // at its phase from the second on
  const auto messages = memory_.take();
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages[0].total_bytes(), 4000U * 1024);
  EXPECT_EQ(messages[0].available_bytes(), 1000U * 1024);
  EXPECT_FLOAT_EQ(messages[0].used_percent(), 75.0F);
  EXPECT_EQ(messages[0].stamp().sec(), 1'767'225'600);
  EXPECT_EQ(messages[3].stamp().sec() - messages[2].stamp().sec(), 1);
  EXPECT_EQ(messages[3].stamp().nanosec(), messages[1].stamp().nanosec());
}

TEST_F(TelemetryTest, ReportsLoadFromTheSecondLookOn) {
  start();
  bus_.run_for(seconds(0.5));
  EXPECT_TRUE(load_.take().empty());
  write("stat", "cpu 130 0 0 170 0 0 0 0\ncpu0 130 0 0 170 0 0 0 0\n");
  bus_.run_for(seconds(1));
  const auto messages = load_.take();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_FLOAT_EQ(messages[0].load_percent(), 30.0F);
  EXPECT_THAT(messages[0].core_percent(), ElementsAre(30.0F));
}

TEST(TelemetryOfAnotherComputer, ReadsItsFiles) {
  class Files final : public DeviceFiles {
   public:
    std::optional<std::string> read(const std::string& path) override {
      if (path.find("meminfo") == std::string::npos) return std::nullopt;
      return "MemTotal: 8000 kB\nMemAvailable: 6000 kB\n";
    }
  };
  Computer other;
  other.devices.add<DeviceFiles>(
      [](const std::string&, const Devices::Readable&) { return std::make_unique<Files>(); });
  SimBus bus;
  Context context = Context(bus, "telemetry", Role::uxv).with_computer(other);
  SimReader<topic::MemoryUsage> memory(bus);
  SimReader<topic::CpuTemperature> temperature(bus);
  TelemetryComponent sut(context, {});
  bus.add(sut);
  EXPECT_FLOAT_EQ(memory.take().at(0).used_percent(), 25.0F);
  EXPECT_EQ(temperature.take().at(0).header().frame_id(), "absent");
}

TEST_F(TelemetryTest, StatesThatThereIsNoThermometer) {
  std::filesystem::remove_all(root_ / "thermal");
  start();
  bus_.run_for(seconds(0.5));
  const auto message = temperature_.take().at(0);
  EXPECT_TRUE(std::isnan(message.temperature()));
  EXPECT_EQ(message.header().frame_id(), "absent");
}

TEST_F(TelemetryTest, ReportsNoNumberWhileTheThermometerFails) {
  start();
  bus_.run_for(seconds(0.5));
  const auto good = temperature_.take().at(0);
  EXPECT_DOUBLE_EQ(good.temperature(), 47.25);
  EXPECT_EQ(good.header().frame_id(), "cpu-thermal");
  write("thermal/thermal_zone0/temp", "");
  bus_.run_for(seconds(1));
  const auto failed = temperature_.take().at(0);
  EXPECT_TRUE(std::isnan(failed.temperature()));
  EXPECT_EQ(failed.header().frame_id(), "cpu-thermal");
}

TEST_F(TelemetryTest, GoesOnWithoutAFile) {
  std::filesystem::remove(root_ / "meminfo");
  std::filesystem::remove(root_ / "stat");
  start();
  bus_.run_for(seconds(2));
  EXPECT_TRUE(memory_.take().empty());
  EXPECT_TRUE(load_.take().empty());
  EXPECT_EQ(temperature_.take().size(), 3U);
  write("meminfo", "MemTotal: 4000 kB\nMemAvailable: 4000 kB\n");
  bus_.run_for(seconds(1));
  EXPECT_EQ(memory_.take().at(0).used_percent(), 0.0F);
}

TEST(TelemetryReadme, ShowsTheParameters) {
  std::ifstream file(TOCSIN_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, ::testing::HasSubstr(default_yaml<TelemetryComponent::Params>()));
}

}  // namespace
}  // namespace tocsin
