// SPDX-License-Identifier: Apache-2.0
#include "collision_brake/collision_brake_component.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "geometry/pose_message.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

namespace code = nav2_msgs::msg::CollisionMonitorState_Constants;

/// A vehicle that stands before a wall, `wall_m_` ahead; commands twenty, odometry fifty, scans ten
/// times a second.
class CollisionBrakeComponentTest : public ::testing::Test {
 protected:
  CollisionBrakeComponentTest() {
    bus_.add(sut_);
    topic::TfStatic::Message message;
    geometry_msgs::msg::TransformStamped transform;
    transform.child_frame_id("laser");
    transform.transform().rotation().w(1);
    message.transforms().push_back(transform);
    bus_.publish<topic::TfStatic>(message);
  }
  std::vector<double> drive(double v, double s) {
    for (int i = 0; i < std::lround(s * 50); ++i) {
      if (sends_odometry_) odometry();
      if (sends_scans_ && i % 5 == 0) scan();
      if (sends_commands_ && i % 5 == 2) command(v);
      bus_.run_for(seconds(0.02));
    }
    std::vector<double> speeds;
    for (const auto& one : checked_.take()) speeds.push_back(one.linear().x());
    return speeds;
  }
  void command(double v) {
    topic::CmdVelSelected::Message message;
    message.linear().x(v);
    bus_.publish<topic::CmdVelSelected>(message);
  }
  void odometry() {
    topic::Odom::Message message;
    message.header().stamp(now());
    message.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>({}));
    bus_.publish<topic::Odom>(message);
  }
  void scan() {
    topic::Scan::Message message;
    message.header().stamp(now());
    message.header().frame_id("laser");
    message.angle_min(static_cast<float>(-pi));
    message.angle_increment(static_cast<float>(degree));
    message.range_min(0.1F);
    message.range_max(12);
    for (int i = -180; i < 180; ++i) {
      const double ahead = std::cos(i * degree);
      message.ranges().push_back(static_cast<float>(ahead > 0.3 ? wall_m_ / ahead : 2.5));
    }
    bus_.publish<topic::Scan>(message);
  }
  [[nodiscard]] builtin_interfaces::msg::Time now() {
    const std::int64_t ns = bus_.wall_ns(bus_.now());
    builtin_interfaces::msg::Time stamp;
    stamp.sec(static_cast<std::int32_t>(ns / 1'000'000'000));
    stamp.nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
    return stamp;
  }
  void bypass(bool on) {
    topic::CollisionBrakeBypass::Message message;
    message.data(on);
    bus_.publish<topic::CollisionBrakeBypass>(message);
  }

  SimBus bus_;
  Context context_{bus_, "collision_brake", Role::uxv};
  SimReader<topic::CmdVelChecked> checked_{bus_};
  SimReader<topic::CollisionMonitorState> states_{bus_};
  CollisionBrakeComponent sut_{context_, {}};
  bool sends_odometry_ = true;
  bool sends_scans_ = true;
  bool sends_commands_ = true;
  double wall_m_ = 2.5;
};

TEST_F(CollisionBrakeComponentTest, PassesWhatIsFreeUnchangedAndSaysItOnce) {
  for (const double speed : drive(0.3, 1)) EXPECT_EQ(speed, 0.3);
  const auto states = states_.take();
  ASSERT_EQ(states.size(), 1U);
  EXPECT_EQ(states[0].action_type(), code::DO_NOTHING);
  EXPECT_EQ(states[0].polygon_name(), "");
}

TEST_F(CollisionBrakeComponentTest, StopsBeforeAWallAndSaysWhy) {
  wall_m_ = 0.22;
  EXPECT_EQ(drive(0.3, 1).back(), 0);
  const auto states = states_.take();
  EXPECT_EQ(states.back().action_type(), code::STOP);
  EXPECT_EQ(states.back().polygon_name(), "obstacle");
  EXPECT_EQ(drive(-0.3, 1).back(), -0.3);
}

TEST_F(CollisionBrakeComponentTest, JudgesTheLastVelocityAgainWhenAScanComes) {
  (void)drive(0.5, 1);
  wall_m_ = 0.3;
  sends_commands_ = false;
  command(0.5);
  bus_.run_for(seconds(0.01));
  const auto speeds = drive(0, 0.3);
  ASSERT_GE(speeds.size(), 2U);
  EXPECT_EQ(speeds.front(), 0.5);
  EXPECT_LT(speeds.back(), 0.3);
  EXPECT_TRUE(drive(0, 2).empty()) << "whoever wished it is silent: the smoother's to brake";
}

TEST_F(CollisionBrakeComponentTest, StandsWhenTheLaserOrOdometryFallsSilent) {
  (void)drive(0.3, 1);
  sends_scans_ = false;
  EXPECT_EQ(drive(0.3, 1).back(), 0);
  EXPECT_EQ(states_.take().back().polygon_name(), "no_scan");
  sends_scans_ = true;
  EXPECT_EQ(drive(0.3, 1).back(), 0.3);
  sends_odometry_ = false;
  EXPECT_EQ(drive(0.3, 2).back(), 0);
}

TEST_F(CollisionBrakeComponentTest, APersonSwitchesItOffForTenSecondsAndItIsSaid) {
  wall_m_ = 0.22;
  (void)drive(0.3, 1);
  bypass(true);
  EXPECT_EQ(drive(0.3, 1).back(), 0.3);
  EXPECT_EQ(states_.take().back().polygon_name(), "bypass");
  EXPECT_EQ(drive(0.3, 10).back(), 0);
  bypass(true);
  EXPECT_EQ(drive(0.3, 1).back(), 0.3);
  bypass(false);
  EXPECT_EQ(drive(0.3, 1).back(), 0);
}

TEST_F(CollisionBrakeComponentTest, SaysNothingOfItsOwn) {
  sends_commands_ = false;
  EXPECT_TRUE(drive(0, 5).empty());
}

}  // namespace
}  // namespace tocsin
