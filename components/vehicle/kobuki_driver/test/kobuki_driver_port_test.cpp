// SPDX-License-Identifier: Apache-2.0
/// The component and its port: absent, lost, occupied, simulated, restarted.
#include <gmock/gmock.h>

#include <cstdio>

#include "component_rig.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using KobukiDriverPortTest = KobukiDriverComponentTest;

/// A simulated computer with one base on /dev/kobuki.
class ModelDevices final : public Devices {
 public:
  explicit ModelDevices(Base& base) : base_(base) {}
  std::unique_ptr<SerialDevice> open_serial(const std::string& path, Readable on) override {
    readable = std::move(on);
    if (path != "/dev/kobuki") return nullptr;
    return std::make_unique<Line>(base_);
  }
  std::unique_ptr<EchoDevice> open_echo(const EchoTarget&, Readable) override { return nullptr; }
  std::optional<std::string> read_text(const std::string&) override { return std::nullopt; }
  Readable readable;

 private:
  class Line final : public SerialDevice {
   public:
    explicit Line(Base& base) : port_(base) {}
    std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
      return port_.read(to, size);
    }
    bool write(const std::uint8_t* bytes, std::size_t size) override {
      return port_.write({bytes, size});
    }

   private:
    ModelPort port_;
  };
  Base& base_;
};

TEST_F(KobukiDriverPortTest, UsesThePortOfASimulatedComputerWhenItsBytesCome) {
  ModelDevices devices(base_);
  context_.devices = &devices;
  sut_ = std::make_unique<KobukiDriverComponent>(context_, params_);
  bus_.add(*sut_);
  bus_.run_for(seconds(0.03));
  odom_.take();
  bus_.run_for(seconds(0.02));
  EXPECT_TRUE(odom_.take().empty());  // nobody told that bytes wait
  devices.readable();
  bus_.run_for(seconds(0.001));
  EXPECT_FALSE(odom_.take().empty());
}

TEST_F(KobukiDriverPortTest, WaitsForASimulatedPortThatIsNotThere) {
  ModelDevices devices(base_);
  context_.devices = &devices;
  params_.device_port = "/dev/other";
  sut_ = std::make_unique<KobukiDriverComponent>(context_, params_);
  bus_.add(*sut_);
  bus_.run_for(seconds(2));
  EXPECT_TRUE(odom_.take().empty());
}

TEST_F(KobukiDriverPortTest, WaitsForAnAbsentPort) {
  base_.plugged = false;
  start();
  run(3);
  EXPECT_NEAR(attempts_, 7, 1);  // at start and every 0.5 s
  EXPECT_TRUE(odom_.take().empty());
  base_.plugged = true;
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverPortTest, ReconnectsAfterTheCableWasPulled) {
  start();
  drive(2, 0.3);
  base_.plugged = false;
  run(1);
  base_.plugged = true;
  odom_.take();
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverPortTest, EndsWhenAnotherProcessHasThePort) {
  const auto busy = [](const std::string& path) {
    return Opened{Opened::Result::busy, nullptr, path + " is in use by minicom (pid 7)", true};
  };
  try {
    KobukiDriverComponent sut(context_, params_, busy);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("kobuki_driver.device_port: /dev/kobuki is in use by minicom"));
  }
}

TEST_F(KobukiDriverPortTest, OutlastsExclusiveUseThatNobodyHolds) {
  const auto busy = [](const std::string&) {
    return Opened{Opened::Result::busy, nullptr, "left over", false};
  };
  EXPECT_NO_THROW(KobukiDriverComponent(context_, params_, busy));
}

TEST_F(KobukiDriverPortTest, GoesOnWhereAKilledDriverWas) {
  context_.run_dir = ::testing::TempDir();
  for (const double dead_s : {0.4, 5.0}) {
    std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
    base_.model.place({});
    start();
    drive(3, 0.3);
    sut_.reset();  // the base rolls out meanwhile
    base_.model.step(bus_.now() + seconds(dead_s) - std::chrono::milliseconds(100),
                     [](Time, ByteView) {});
    run(dead_s);
    odom_.take();
    start();
    run(1);
    EXPECT_NEAR(odom_.take().back().pose().pose().position().x(), base_.model.pose().x_m, 0.02);
  }
  std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
}

TEST_F(KobukiDriverPortTest, ThePoseGoesOnWithoutAJumpAfterTheCableWasPulled) {
  start();
  drive(3, 0.3);
  base_.plugged = false;
  run(1);
  base_.plugged = true;
  odom_.take();
  run(1);
  const auto poses = odom_.take();
  ASSERT_GT(poses.size(), 10U);
  double last_m = poses.front().pose().pose().position().x();
  for (const auto& odom : poses) {
    EXPECT_LT(odom.pose().pose().position().x() - last_m, 0.03);
    last_m = odom.pose().pose().position().x();
  }
}

}  // namespace
}  // namespace tocsin
