// SPDX-License-Identifier: Apache-2.0
/// Topics of the base itself: gyro samples, frames, names, diagnostics, serial bytes.
#include "component_rig.hpp"
#include "kobuki_protocol/dimensions.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using BaseTopicsTest = KobukiDriverComponentTest;

std::int64_t ns_of(const std_msgs::msg::Header& header) {
  return header.stamp().sec() * 1'000'000'000LL + header.stamp().nanosec();
}

TEST_F(BaseTopicsTest, PublishEveryGyroSampleTenMillisecondsApart) {
  SimReader<topic::ImuRaw> raw(bus_);
  start();
  run(2);
  const auto samples = raw.take();
  EXPECT_NEAR(static_cast<double>(samples.size()), 200, 4);
  EXPECT_EQ(ns_of(samples[1].header()) - ns_of(samples[0].header()), 10'000'000);
  EXPECT_EQ(samples[0].header().frame_id(), "gyro_link");
  EXPECT_EQ(samples[0].orientation_covariance()[0], -1);
}

TEST_F(BaseTopicsTest, ShowTheTurnOfTheGyroInImuAndRawImu) {
  SimReader<topic::ImuRaw> raw(bus_);
  start();
  for (int i = 0; i < 30; ++i) {
    topic::CmdVel::Message command;
    command.angular().z(0.5);
    bus_.publish<topic::CmdVel>(command);
    run(0.1);
  }
  EXPECT_NEAR(raw.take().back().angular_velocity().z(), 0.5, 0.02);
  EXPECT_NEAR(imu_.take().back().angular_velocity().z(), 0.5, 0.02);
}

TEST_F(BaseTopicsTest, KeepTheGyroInImuDataWhenOdometryFollowsTheEncoders) {
  params_.driver.odometry.use_gyro_heading = false;
  start();
  run(1);
  base_.model.place({0, 0, 0});
  params_.driver.odometry.use_gyro_heading = false;
  for (int i = 0; i < 20; ++i) {
    topic::CmdVel::Message command;
    command.angular().z(0.5);
    bus_.publish<topic::CmdVel>(command);
    run(0.1);
  }
  const double by_gyro = 2 * std::asin(imu_.take().back().orientation().z());
  EXPECT_NEAR(by_gyro, base_.model.pose().heading_rad, 0.03);
}

TEST_F(BaseTopicsTest, NameFramesAndJointsAsTheReferenceUnlessParametersNameThem) {
  SimReader<topic::DockInfrared> dock(bus_);
  SimReader<topic::SensorsCore> sensors(bus_);
  start();
  run(0.5);
  EXPECT_EQ(dock.take().back().header().frame_id(), "dock_ir_link");
  EXPECT_EQ(sensors.take().back().header().frame_id(), "base_footprint");
  EXPECT_EQ(imu_.take().back().header().frame_id(), "gyro_link");
  params_.frame.odom_frame = "world";
  params_.frame.base_frame = "base_link";
  params_.frame.wheel_left_joint_name = "left";
  start();
  run(0.5);
  EXPECT_EQ(odom_.take().back().header().frame_id(), "world");
  EXPECT_EQ(tf_.take().back().transforms()[0].child_frame_id(), "base_link");
  EXPECT_EQ(joints_.take().back().name()[0], "left");
}

TEST_F(BaseTopicsTest, PublishDiagnosticsOnceASecond) {
  SimReader<topic::Diagnostics> diagnostics(bus_);
  start();
  run(4.5);
  const auto arrays = diagnostics.take();
  EXPECT_NEAR(static_cast<double>(arrays.size()), 5, 1);
  const auto& status = arrays.back().status();
  ASSERT_EQ(status.size(), 11U);
  EXPECT_EQ(status[0].name(), "kobuki_driver: Watchdog");
  EXPECT_EQ(status[0].level(), 0);
  EXPECT_THAT(status[0].hardware_id(), HasSubstr("-"));
  base_.plugged = false;
  run(3);
  EXPECT_EQ(diagnostics.take().back().status()[0].level(), 2);
}

TEST_F(BaseTopicsTest, PublishSerialBytesOnDemandOnly) {
  SimReader<topic::RawStream> received(bus_);
  SimReader<topic::RawCommand> sent(bus_);
  SimReader<topic::RawControl> control(bus_);
  start();
  run(0.2);
  EXPECT_TRUE(received.take().empty());
  sut_.reset();
  params_.publish_serial_bytes = true;
  start();
  drive(0.2, 0.3);
  EXPECT_THAT(received.take().back().data(), HasSubstr("aa 55 4d "));
  EXPECT_THAT(sent.take().back().data(), HasSubstr("aa 55 06 01 04 2c 01 00 00 2e "));
  EXPECT_THAT(control.take().back().data(), ::testing::ElementsAre(300, 0));
}

}  // namespace
}  // namespace tocsin
