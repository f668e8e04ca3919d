// SPDX-License-Identifier: Apache-2.0
#include "rplidar_driver/rplidar_driver_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "devices/computer.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "laser_model/simulated_laser.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

/// A laser in a room of 6 x 4 m, at its middle, behind a cable.
struct Laser {
  explicit Laser(const SimBus& clock) : bus(clock) {}
  const SimBus& bus;
  laser::SimulatedLaser device{
      laser::find_laser_profile("rplidar_a1"),
      std::make_shared<laser::Scene>(std::vector<geometry::Wall>{
          {-3, -2, 3, -2, 6.9}, {3, -2, 3, 2, 6.9}, {3, 2, -3, 2, 6.9}, {-3, 2, -3, -2, 6.9}}),
      {},
      1,
      bus.now()};
  std::vector<std::uint8_t> arrived;
  bool plugged = true;
  bool dtr = true;
  unsigned baud = 0;
};

class LaserPort final : public SerialDevice {
 public:
  explicit LaserPort(Laser& laser) : laser_(laser) {}
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    laser_.device.step({}, laser_.bus.now(), [this](ByteView bytes) {
      laser_.arrived.insert(laser_.arrived.end(), bytes.begin(), bytes.end());
    });
    if (!laser_.plugged) return std::nullopt;
    const std::size_t count = std::min(size, laser_.arrived.size());
    std::copy_n(laser_.arrived.begin(), count, to);
    laser_.arrived.erase(laser_.arrived.begin(),
                         laser_.arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    laser_.device.receive({bytes, size}, laser_.bus.now());
    return laser_.plugged;
  }
  bool set_speed(unsigned baud) override {
    laser_.baud = baud;
    return true;
  }
  bool set_dtr(bool on) override {
    laser_.dtr = on;
    return true;
  }

 private:
  Laser& laser_;
};

class RplidarDriverComponentTest : public ::testing::Test {
 protected:
  RplidarDriverComponentTest() {
    computer_.devices.add<SerialDevice>(
        [this](const std::string& path, const Devices::Readable&) -> OpenedSerial {
          if (is_held_) return {OpenedSerial::Result::busy, path + " is in use by 7", true};
          if (!laser_.plugged || path != "/dev/rplidar") return {};
          return std::make_unique<LaserPort>(laser_);
        });
  }
  void start() { sut_ = std::make_unique<RplidarDriverComponent>(context_, params_); }
  void run(double s) {
    for (const Time end = bus_.now() + seconds(s); bus_.now() < end;) {
      sut_->tick(bus_.now());
      bus_.run_for(std::chrono::milliseconds(10));
    }
  }
  /// The last status of the laser.
  diagnostic_msgs::msg::DiagnosticStatus status() { return diagnostics_.take().back().status()[0]; }

  SimBus bus_;
  Laser laser_{bus_};
  bool is_held_ = false;
  Computer computer_;
  Context context_ = Context(bus_, "rplidar_driver", Role::uxv).with_computer(computer_);
  RplidarDriverComponent::Params params_;
  std::unique_ptr<RplidarDriverComponent> sut_;
  SimReader<topic::Scan> scan_{bus_};
  SimReader<topic::TfStatic> tf_static_{bus_};
  SimReader<topic::Diagnostics> diagnostics_{bus_};
};

TEST_F(RplidarDriverComponentTest, PublishesScansAsRos2HasThem) {
  start();
  run(5);
  EXPECT_EQ(laser_.baud, 115200U);
  EXPECT_FALSE(laser_.dtr) << "the motor turns while it is cleared";
  const auto scans = scan_.take();
  ASSERT_GT(scans.size(), 10U);
  const auto& scan = scans.back();
  EXPECT_EQ(scan.header().frame_id(), "laser");
  EXPECT_NEAR(scan.angle_min(), -pi, 1e-6);
  EXPECT_NEAR(scan.angle_max(), pi - 2 * pi / 360, 1e-5);
  EXPECT_NEAR(scan.scan_time(), 1 / 5.5, 0.01);
  ASSERT_EQ(scan.ranges().size(), 360U);
  const std::vector<std::pair<std::size_t, double>> walls{{180, 3}, {270, 2}, {0, 3}, {90, 2}};
  for (const auto& [beam, range_m] : walls) {
    if (std::isfinite(scan.ranges()[beam])) {
      EXPECT_NEAR(scan.ranges()[beam], range_m, 0.1) << beam;
    }
  }
  EXPECT_EQ(status().level(), 0);
}

TEST_F(RplidarDriverComponentTest, TellsWhereItIsMounted) {
  params_.x_m = -0.1;
  params_.yaw_rad = pi / 2;
  start();
  run(0.1);
  const auto mounts = tf_static_.take();
  ASSERT_EQ(mounts.size(), 1U);
  const auto& mount = mounts[0].transforms()[0];
  EXPECT_EQ(mount.header().frame_id(), "base_footprint");
  EXPECT_EQ(mount.child_frame_id(), "laser");
  EXPECT_EQ(mount.transform().translation().x(), -0.1);
  EXPECT_NEAR(mount.transform().rotation().z(), std::sin(pi / 4), 1e-12);
}

TEST_F(RplidarDriverComponentTest, WaitsForAnAbsentPortAndOutlivesAPulledCable) {
  laser_.plugged = false;
  start();
  run(2);
  EXPECT_THAT(status().message(), HasSubstr("the port is closed"));
  laser_.plugged = true;
  run(4);
  EXPECT_FALSE(scan_.take().empty());
  laser_.plugged = false;
  run(2);
  scan_.take();
  EXPECT_EQ(status().level(), 2);
  laser_.plugged = true;
  run(4);
  EXPECT_FALSE(scan_.take().empty());
  EXPECT_EQ(status().level(), 0);
}

TEST_F(RplidarDriverComponentTest, EndsWhenAnotherProcessHasThePort) {
  is_held_ = true;
  try {
    start();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("rplidar_driver.device_port: /dev/rplidar is in use"));
  }
}

TEST_F(RplidarDriverComponentTest, SaysThatTheMotorStalls) {
  start();
  run(4);
  laser_.device.device().stall(true, bus_.now());
  run(3);
  const auto said = status();
  EXPECT_EQ(said.level(), 2);
  EXPECT_THAT(said.message(), HasSubstr("does not turn"));
}

TEST_F(RplidarDriverComponentTest, LeavesTheLaserAtRestWhenItEnds) {
  start();
  run(4);
  EXPECT_TRUE(laser_.device.device().is_scanning());
  sut_.reset();
  EXPECT_FALSE(laser_.device.device().is_scanning());
  EXPECT_TRUE(laser_.dtr);
}

TEST_F(RplidarDriverComponentTest, RefusesAViewOfNothing) {
  params_.driver.turn.angle_max_deg = -180;
  EXPECT_THROW(start(), ConfigError);
}

}  // namespace
}  // namespace tocsin
