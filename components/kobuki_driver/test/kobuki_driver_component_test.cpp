// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/kobuki_driver_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "kobuki_model/base_model.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using kobuki::ByteView;
using kobuki::Opened;
using ::testing::HasSubstr;

/// A base in the bus's virtual time and the cable to it.
struct Base {
  explicit Base(const SimBus& clock)
      : bus(clock), model({}, kobuki::open_floor(), {}, 1, bus.now()) {}
  const SimBus& bus;
  kobuki::BaseModel model;
  std::vector<std::uint8_t> arrived;
  bool plugged = true;
};

class ModelPort final : public kobuki::BytePort {
 public:
  explicit ModelPort(Base& base) : base_(base) {}
  int descriptor() const override { return -1; }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    base_.model.step(base_.bus.now(), [this](Time, ByteView frame) {
      base_.arrived.insert(base_.arrived.end(), frame.begin(), frame.end());
    });
    if (!base_.plugged) return std::nullopt;
    const std::size_t count = std::min(size, base_.arrived.size());
    std::copy_n(base_.arrived.begin(), count, to);
    base_.arrived.erase(base_.arrived.begin(),
                        base_.arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(ByteView bytes) override {
    base_.model.receive(bytes, base_.bus.now());
    return base_.plugged;
  }

 private:
  Base& base_;
};

class KobukiDriverComponentTest : public ::testing::Test {
 protected:
  void start() {
    sut_ = std::make_unique<KobukiDriverComponent>(context_, params_,
                                                   [this](const std::string&) { return open(); });
  }
  Opened open() {
    ++attempts_;
    if (!base_.plugged) return {Opened::Result::absent, nullptr, "no such file", false};
    return {Opened::Result::open, std::make_unique<ModelPort>(base_), {}, false};
  }
  void run(double duration_s, double v_mps = 0, bool commanded = false) {
    for (int i = 0; i < std::lround(duration_s / 0.01); ++i) {
      if (commanded && i % 5 == 0) {
        topic::CmdVel::Message command;
        command.linear().x(v_mps);
        bus_.publish<topic::CmdVel>(command);
      }
      if (sut_) sut_->tick(bus_.now());
      bus_.run_for(std::chrono::milliseconds(10));
    }
  }
  void drive(double duration_s, double v_mps) { run(duration_s, v_mps, true); }

  SimBus bus_;
  Context context_{bus_, "kobuki_driver", "uxv", ""};
  KobukiDriverComponent::Params params_;
  Base base_{bus_};
  int attempts_ = 0;
  std::unique_ptr<KobukiDriverComponent> sut_;
  SimReader<topic::Odom> odom_{bus_};
  SimReader<topic::Tf> tf_{bus_};
  SimReader<topic::JointStates> joints_{bus_};
  SimReader<topic::Imu> imu_{bus_};
  SimReader<topic::BatteryState> battery_{bus_};
};

TEST_F(KobukiDriverComponentTest, PublishesOdometryAtFiftyHertz) {
  start();
  drive(4, 0.3);
  const auto odom = odom_.take();
  EXPECT_NEAR(static_cast<double>(odom.size()), 200, 2);
  const auto& last = odom.back();
  EXPECT_EQ(last.header().frame_id(), "odom");
  EXPECT_EQ(last.child_frame_id(), "base_footprint");
  EXPECT_NEAR(last.pose().pose().position().x(), base_.model.pose().x_m, 0.03);
  EXPECT_NEAR(last.twist().twist().linear().x(), 0.3, 0.02);
  EXPECT_NEAR(last.pose().pose().orientation().w(), 1, 0.01);
}

TEST_F(KobukiDriverComponentTest, HasTheCovariancesOfTheReference) {
  start();
  run(1);
  const auto odom = odom_.take().back();
  EXPECT_EQ(odom.pose().covariance()[0], 0.1);
  EXPECT_EQ(odom.pose().covariance()[7], 0.1);
  EXPECT_EQ(odom.pose().covariance()[14], 1e10);
  EXPECT_EQ(odom.pose().covariance()[35], 0.05);
  const auto imu = imu_.take().back();
  EXPECT_EQ(imu.orientation_covariance()[8], 0.05);
  EXPECT_GT(imu.orientation_covariance()[0], 1e300);
  EXPECT_EQ(imu.linear_acceleration_covariance()[0], -1);
}

TEST_F(KobukiDriverComponentTest, IsLessSureOfEncoderHeading) {
  params_.driver.odometry.use_gyro_heading = false;
  start();
  run(1);
  EXPECT_EQ(odom_.take().back().pose().covariance()[35], 0.2);
}

TEST_F(KobukiDriverComponentTest, PublishesTheBatteryAsAShareOfOne) {
  start();
  run(3.5);
  const auto battery = battery_.take();
  EXPECT_NEAR(static_cast<double>(battery.size()), 4, 1);
  EXPECT_GT(battery[0].percentage(), 0.5F);
  EXPECT_LE(battery[0].percentage(), 1.0F);
  EXPECT_NEAR(battery[0].voltage(), 16.2, 0.3);
  EXPECT_EQ(battery[0].power_supply_status(), 2);
  base_.model.power().plug(kobuki::ChargingSource::adapter);
  run(1.5);
  EXPECT_EQ(battery_.take().back().power_supply_status(), 1);
}

TEST_F(KobukiDriverComponentTest, PublishesTransformAndJointsUnlessTurnedOff) {
  start();
  run(1);
  EXPECT_GT(tf_.take().size(), 40U);
  EXPECT_EQ(joints_.take().back().name()[0], "wheel_left_joint");
  sut_.reset();
  params_.publish_tf = false;
  start();
  run(1);
  EXPECT_TRUE(tf_.take().empty());
  EXPECT_GT(odom_.take().size(), 40U);
}

TEST_F(KobukiDriverComponentTest, PublishesRawSensorsAndEvents) {
  SimReader<topic::SensorsCore> sensors(bus_);
  SimReader<topic::BumperEvents> bumpers(bus_);
  SimReader<topic::CliffEvents> cliffs(bus_);
  SimReader<topic::PowerEvents> power(bus_);
  start();
  run(0.5);
  base_.model.inputs().bumper = kobuki::left_bit;
  base_.model.inputs().cliff = kobuki::right_bit;
  base_.model.power().plug(kobuki::ChargingSource::dock);
  run(0.5);
  EXPECT_NEAR(static_cast<double>(sensors.take().size()), 50, 2);
  const auto bumps = bumpers.take();
  ASSERT_EQ(bumps.size(), 1U);
  EXPECT_EQ(bumps[0].bumper(), 0);
  EXPECT_EQ(bumps[0].state(), 1);
  const auto edges = cliffs.take();
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].sensor(), 2);
  EXPECT_LT(edges[0].bottom(), 1000);
  const auto plugged = power.take();
  ASSERT_EQ(plugged.size(), 1U);
  EXPECT_EQ(plugged[0].event(), 2);
}

TEST_F(KobukiDriverComponentTest, PublishesStateAndVersions) {
  SimReader<topic::RobotState> states(bus_);
  SimReader<topic::VersionInfo> versions(bus_);
  start();
  run(1);
  const auto online = states.take();
  ASSERT_EQ(online.size(), 1U);
  EXPECT_EQ(online[0].state(), 1);
  const auto known = versions.take();
  ASSERT_EQ(known.size(), 1U);
  EXPECT_EQ(known[0].firmware(), "1.2.0");
  EXPECT_EQ(known[0].udid().size(), 3U);
  base_.plugged = false;
  run(0.2);
  EXPECT_EQ(states.take().back().state(), 0);
}

TEST_F(KobukiDriverComponentTest, KeepsRawSensorsToItselfWhenAskedTo) {
  params_.publish_base_topics = false;
  SimReader<topic::SensorsCore> sensors(bus_);
  start();
  run(0.5);
  EXPECT_TRUE(sensors.take().empty());
}

TEST_F(KobukiDriverComponentTest, StopsTheBaseWhenVelocitiesStop) {
  start();
  drive(2, 0.3);
  EXPECT_GT(base_.model.velocity().linear_mps, 0.25);
  run(1.2);
  EXPECT_EQ(base_.model.velocity().linear_mps, 0);
}

TEST_F(KobukiDriverComponentTest, LeavesTheBaseStandingWhenItEnds) {
  start();
  drive(2, 0.3);
  sut_.reset();
  base_.model.step(bus_.now() + seconds(1), [](Time, ByteView) {});
  EXPECT_EQ(base_.model.velocity().linear_mps, 0);
}

/// A simulated computer with one base on /dev/kobuki.
class ModelDevices final : public Devices {
 public:
  explicit ModelDevices(Base& base) : base_(base) {}
  std::unique_ptr<SerialDevice> open_serial(const std::string& path, Readable on) override {
    readable = std::move(on);
    if (path != "/dev/kobuki") return nullptr;
    return std::make_unique<Line>(base_);
  }
  std::unique_ptr<EchoDevice> open_echo(const std::string&, std::size_t, Readable) override {
    return nullptr;
  }
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

TEST_F(KobukiDriverComponentTest, UsesThePortOfASimulatedComputerWhenItsBytesCome) {
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

TEST_F(KobukiDriverComponentTest, WaitsForASimulatedPortThatIsNotThere) {
  ModelDevices devices(base_);
  context_.devices = &devices;
  params_.device_port = "/dev/other";
  sut_ = std::make_unique<KobukiDriverComponent>(context_, params_);
  bus_.add(*sut_);
  bus_.run_for(seconds(2));
  EXPECT_TRUE(odom_.take().empty());
}

TEST_F(KobukiDriverComponentTest, WaitsForAnAbsentPort) {
  base_.plugged = false;
  start();
  run(3);
  EXPECT_NEAR(attempts_, 7, 1);  // at start and every 0.5 s
  EXPECT_TRUE(odom_.take().empty());
  base_.plugged = true;
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverComponentTest, ReconnectsAfterTheCableWasPulled) {
  start();
  drive(2, 0.3);
  base_.plugged = false;
  run(1);
  base_.plugged = true;
  odom_.take();
  run(1);
  EXPECT_GT(odom_.take().size(), 20U);
}

TEST_F(KobukiDriverComponentTest, EndsWhenAnotherProcessHasThePort) {
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

TEST_F(KobukiDriverComponentTest, OutlastsExclusiveUseThatNobodyHolds) {
  const auto busy = [](const std::string&) {
    return Opened{Opened::Result::busy, nullptr, "left over", false};
  };
  EXPECT_NO_THROW(KobukiDriverComponent(context_, params_, busy));
}

TEST_F(KobukiDriverComponentTest, GoesOnWhereAKilledDriverWas) {
  context_.run_dir = ::testing::TempDir();
  std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
  start();
  drive(3, 0.3);
  sut_.reset();  // the base rolls out meanwhile
  base_.model.step(bus_.now() + std::chrono::milliseconds(300), [](Time, ByteView) {});
  run(0.4);
  odom_.take();
  start();
  run(1);
  EXPECT_NEAR(odom_.take().back().pose().pose().position().x(), base_.model.pose().x_m, 0.02);
  std::remove((context_.run_dir + "/kobuki_driver.odometry").c_str());
}

TEST(KobukiDriverParams, ListEachNameOnce) {
  const auto node = YAML::Load(default_yaml<KobukiDriverComponent::Params>());
  EXPECT_EQ(node["cmd_vel_timeout_s"].as<double>(), 0.6);
  EXPECT_NO_THROW((void)load_parameters<KobukiDriverComponent::Params>(node, "d", "f"));
}

}  // namespace
}  // namespace tocsin
