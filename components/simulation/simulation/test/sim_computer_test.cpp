// SPDX-License-Identifier: Apache-2.0
#include "sim_computer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "devices/device_files.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "kobuki_protocol/command.hpp"

namespace tocsin::simulation {
namespace {

class SimComputerTest : public ::testing::Test {
 protected:
  SimComputerTest() {
    sut_.add_base(base_);
    sut_.add_peer("10.77.0.2");
  }
  void run_for(double s) {
    const Time end = core_.now + seconds(s);
    const auto next = [this] {
      return std::min({core_.events.next(), link_.next_event(), base_.next_event()});
    };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      base_.advance();
      link_.advance();
    }
    core_.now = end;
  }
  static radio::ChannelParams wire() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    params.delay_s = 0.01;
    params.outages_s = {10, 5};
    return params;
  }
  static BaseOptions base_options() {
    BaseOptions options;
    options.link = "/dev/kobuki";
    options.start = {0, 4, 0};
    return options;
  }

  Core core_;
  RadioLink link_{core_, wire(), {{}, 1, 1}};
  SimBase base_{core_, base_options()};
  SimComputer sut_{core_, link_, {"uxv", radio::Direction::uplink}, "/run/wireless"};
  std::unique_ptr<DeviceFiles> files_ = sut_.devices.open<DeviceFiles>();
  int readable_ = 0;
  Devices::Readable count_ = [this] { ++readable_; };
};

TEST_F(SimComputerTest, EchoComesBackAfterTheRoundTrip) {
  const auto echo = sut_.devices.open<EchoDevice>({"10.77.0.2", 64}, count_);
  const Time sent = core_.now;
  EXPECT_EQ(echo->send(5).error, 0);
  EXPECT_FALSE(echo->receive());
  run_for(1);
  EXPECT_EQ(readable_, 1);
  const auto reply = echo->receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->sequence, 5);
  EXPECT_EQ(reply->received_at, sent + seconds(0.02));
  EXPECT_EQ(link_.pushed(), 2U);
}

TEST_F(SimComputerTest, KnowsTheTruePoseOfItsBase) {
  const geometry::Pose pose = sut_.devices.open<TruePose>()->read();
  EXPECT_EQ(pose.x_m, 0);
  EXPECT_EQ(pose.y_m, 4);
  const SimComputer station(core_, link_, {"gcs", radio::Direction::downlink}, "");
  EXPECT_THROW((void)station.devices.open<TruePose>(), ConfigError) << "no vehicle";
}

/// Keeps what the channel told last.
class ChannelWatch : public Observer {
 public:
  void on_channel(const radio::LinkReport& report, Time) override { last = report; }
  radio::LinkReport last{};
};

TEST_F(SimComputerTest, EchoesGoBothWaysWithTheDscpOfTheirTarget) {
  ChannelWatch watch;
  core_.observers = {&watch};
  (void)sut_.devices.open<EchoDevice>({"10.77.0.2", 64, 8}, count_)->send(5);
  (void)sut_.devices.open<EchoDevice>({"10.77.0.2", 64}, count_)->send(6);
  run_for(2);
  constexpr auto background = static_cast<std::size_t>(radio::AccessCategory::background);
  constexpr auto best_effort = static_cast<std::size_t>(radio::AccessCategory::best_effort);
  for (const auto& direction : {watch.last.uplink, watch.last.downlink}) {
    EXPECT_EQ(direction.categories[background].delivered, 1U);
    EXPECT_EQ(direction.categories[best_effort].delivered, 1U);
  }
}

TEST_F(SimComputerTest, EchoToNobodyOrOverADeadLinkOrAfterItsEndDoesNotComeBack) {
  (void)sut_.devices.open<EchoDevice>({"10.77.0.2", 64}, count_)->send(5);
  const auto nobody = sut_.devices.open<EchoDevice>({"10.77.0.3", 64}, count_);
  (void)nobody->send(5);
  run_for(11);
  const auto over_dead_link = sut_.devices.open<EchoDevice>({"10.77.0.2", 64}, count_);
  (void)over_dead_link->send(5);
  run_for(9);
  EXPECT_EQ(readable_, 0);
  EXPECT_THROW((void)sut_.devices.open<EchoDevice>({"", 64}, count_), ConfigError);
}

TEST_F(SimComputerTest, HasOnlyThePortsOfItsBases) {
  EXPECT_EQ(sut_.devices.try_open<SerialDevice>("/dev/other", count_).result,
            OpenedSerial::Result::absent);
  EXPECT_EQ(sut_.devices.try_open<SerialDevice>("/dev/kobuki", count_).result,
            OpenedSerial::Result::open);
  run_for(1);
  EXPECT_EQ(readable_, 0) << "it is closed again";
}

TEST_F(SimComputerTest, SerialPortGivesTheFramesOfTheBase) {
  const auto port = sut_.devices.try_open<SerialDevice>("/dev/kobuki", count_).device;
  run_for(0.1);
  EXPECT_EQ(readable_, 4);  // the fifth is still on the wire
  std::array<std::uint8_t, 1024> bytes{};
  EXPECT_GT(port->read(bytes.data(), bytes.size()).value_or(0), 300U);
  EXPECT_EQ(bytes[0], 0xaa);  // header of the protocol
  EXPECT_EQ(bytes[1], 0x55);
  EXPECT_EQ(port->read(bytes.data(), bytes.size()).value_or(9), 0U);
}

TEST_F(SimComputerTest, SerialPortCarriesCommandsToTheBase) {
  const auto port = sut_.devices.try_open<SerialDevice>("/dev/kobuki", count_).device;
  // Base control: 100 mm/s straight on, with header, length and checksum (Kobuki protocol).
  std::array<std::uint8_t, 10> command{0xaa, 0x55, 0x06, 0x01, 0x04, 100, 0, 0, 0, 0};
  for (std::size_t i = 2; i < 9; ++i)
    command[9] = static_cast<std::uint8_t>(command[9] ^ command[i]);
  ASSERT_TRUE(port->write(command.data(), command.size()));
  run_for(2);
  EXPECT_NEAR(base_.model().pose().x_m, 0.18, 0.02);
}

TEST_F(SimComputerTest, TellsTheWirelessStateUnderBothPaths) {
  const auto text = files_->read("/proc/net/wireless");
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("wlan0:"), std::string::npos);
  EXPECT_EQ(text, files_->read("/run/wireless"));
}

TEST_F(SimComputerTest, RadioIsReadFromTheFileThatTellsOfIt) {
  const auto reading =
      sut_.devices.open<network::WirelessDevice>({"wlan0", "/run/wireless"})->read();
  EXPECT_EQ(reading.source, network::WirelessSource::proc);
  EXPECT_TRUE(reading.signal_dbm.has_value());
  EXPECT_EQ(sut_.devices.open<network::WirelessDevice>({"wlan0", "/run/other"})->read().note,
            "/run/other cannot be read");
}

TEST_F(SimComputerTest, CpuTimesGrowWithVirtualTime) {
  const auto before = files_->read("/proc/stat");
  EXPECT_EQ(before, files_->read("/proc/stat"));
  run_for(1);
  EXPECT_NE(before, files_->read("/proc/stat"));
  EXPECT_FALSE(files_->read("/etc/passwd"));
}

TEST(BaseOptions, AreReadFromTheCommandLine) {
  const BaseOptions sut = read_base_options(
      {"base",
       {"kobuki_simulator", "--link", "/run/kobuki", "--start", "1,-2,0.5", "--seed", "9"}});
  EXPECT_EQ(sut.link, "/run/kobuki");
  EXPECT_EQ(sut.start.x_m, 1);
  EXPECT_EQ(sut.start.y_m, -2);
  EXPECT_EQ(sut.start.heading_rad, 0.5);
  EXPECT_EQ(sut.seed, 9U);
}

TEST(BaseOptions, AreRefusedWhenWrong) {
  const auto read = [](const std::vector<std::string>& more) {
    std::vector<std::string> command{"kobuki_simulator"};
    command.insert(command.end(), more.begin(), more.end());
    return read_base_options({"base", command});
  };
  EXPECT_THROW((void)read({}), ConfigError);
  EXPECT_THROW((void)read({"--link", "a", "--start", "1,2"}), ConfigError);
  EXPECT_THROW((void)read({"--link", "a", "--seed", "-1"}), ConfigError);
  EXPECT_THROW((void)read({"--link", "a", "--config", "/no/such/file"}), ConfigError);
  const TemporaryFolder folder;
  const std::string file = folder.write("base.yaml", "modell: {command_timeout_s: 1}\n");
  EXPECT_THROW((void)read({"--link", "a", "--config", file}), ConfigError) << "an unknown key";
}

}  // namespace
}  // namespace tocsin::simulation
