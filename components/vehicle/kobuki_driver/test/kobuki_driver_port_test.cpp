// SPDX-License-Identifier: Apache-2.0
/// The component and its port: absent, lost, occupied, without a descriptor, restarted.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <vector>

#include "component_rig.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using KobukiDriverPortTest = KobukiDriverComponentTest;

TEST_F(KobukiDriverPortTest, ReadsAPortWithoutADescriptorWhenItsBytesCome) {
  sut_ = std::make_unique<KobukiDriverComponent>(context_, params_);
  bus_.add(*sut_);
  bus_.run_for(seconds(0.03));
  odom_.take();
  bus_.run_for(seconds(0.02));
  EXPECT_TRUE(odom_.take().empty());  // nobody told that bytes wait
  devices_.readable();
  bus_.run_for(seconds(0.001));
  EXPECT_FALSE(odom_.take().empty());
}

/// A port that gives one portion of bytes for each read.
class PortionPort final : public SerialDevice {
 public:
  explicit PortionPort(std::deque<std::vector<std::uint8_t>>& portions) : portions_(portions) {}
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t) override {
    if (portions_.empty()) return 0;
    const auto portion = portions_.front();
    portions_.pop_front();
    std::copy(portion.begin(), portion.end(), to);
    return portion.size();
  }
  bool write(const std::uint8_t*, std::size_t) override { return true; }
  [[nodiscard]] std::optional<int> descriptor() const override { return 1234; }

 private:
  std::deque<std::vector<std::uint8_t>>& portions_;
};

TEST_F(KobukiDriverPortTest, WakesForTheFirstBytesOfAFrameAndForItsEnd) {
  std::vector<std::uint8_t> frame;
  base_.model.step(bus_.now() + seconds(0.02), [&](Time, ByteView bytes) {
    if (frame.empty()) frame.assign(bytes.begin(), bytes.end());
  });
  ASSERT_GT(frame.size(), 70U);
  std::deque<std::vector<std::uint8_t>> portions;
  Computer computer;
  computer.devices.add<SerialDevice>([&](const std::string&, const Devices::Readable&) {
    return OpenedSerial(std::make_unique<PortionPort>(portions));
  });
  Context context = Context(bus_, "kobuki_driver", Role::uxv).with_computer(computer);
  KobukiDriverComponent sut(context, params_);
  const auto tick = [&](Duration after) {
    bus_.run_for(after);
    sut.schedule().begin_tick(bus_.now());
    sut.tick(bus_.now());
  };
  const std::vector<int> listens{1234};
  tick(Duration{0});
  EXPECT_EQ(sut.schedule().descriptors, listens);
  portions = {{frame.begin(), frame.begin() + 10}};
  tick(std::chrono::milliseconds(1));
  EXPECT_TRUE(sut.schedule().descriptors.empty()) << "the rest does not wake it";
  const double rest_s = static_cast<double>(frame.size() - 10) * 10 / 115200;
  EXPECT_NEAR(to_seconds(sut.schedule().due() - bus_.now()), rest_s + 0.0005, 1e-6);
  portions = {{frame.begin() + 10, frame.end()}};
  tick(seconds(rest_s + 0.0005));
  EXPECT_FALSE(odom_.take().empty());
  EXPECT_EQ(sut.schedule().descriptors, listens);
  portions = {{frame.begin(), frame.begin() + 10}};
  tick(std::chrono::milliseconds(12));
  tick(std::chrono::milliseconds(8));
  EXPECT_EQ(sut.schedule().descriptors, listens) << "the cable was pulled within a frame";
}

TEST_F(KobukiDriverPortTest, WaitsForAnAbsentPort) {
  base_.plugged = false;
  start();
  run(3);
  EXPECT_NEAR(devices_.attempts, 7, 1);  // at start and every 0.5 s
  EXPECT_TRUE(odom_.take().empty());
  base_.plugged = true;
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverPortTest, EndsWhenAnotherProcessHasThePort) {
  devices_.in_use = "/dev/kobuki is in use by minicom (pid 7)";
  devices_.held = true;
  try {
    KobukiDriverComponent sut(context_, params_);
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("kobuki_driver.device_port: /dev/kobuki is in use by minicom"));
  }
  devices_.held = false;
  EXPECT_NO_THROW(KobukiDriverComponent(context_, params_)) << "it outlasts what nobody holds";
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
