// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/kobuki_driver_component.hpp"

#include <yaml-cpp/yaml.h>

#include "component_rig.hpp"
#include "foundation/parameters.hpp"

namespace tocsin {
namespace {

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
  params_.frame.publish_tf = false;
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
  params_.publish_base_topics = false;
  start();
  sensors.take();
  run(0.5);
  EXPECT_TRUE(sensors.take().empty());
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

TEST_F(KobukiDriverComponentTest, LeavesTheBaseStandingWhenItEnds) {
  start();
  drive(2, 0.3);
  sut_.reset();
  base_.model.step(bus_.now() + seconds(1), [](Time, ByteView) {});
  EXPECT_EQ(base_.model.velocity().linear_mps, 0);
}

TEST(KobukiDriverParams, ListEachNameOnce) {
  const auto node = YAML::Load(default_yaml<KobukiDriverComponent::Params>());
  EXPECT_EQ(node["cmd_vel_timeout_s"].as<double>(), 0.6);
  EXPECT_NO_THROW((void)load_parameters<KobukiDriverComponent::Params>(node, "d", "f"));
}

}  // namespace
}  // namespace tocsin
