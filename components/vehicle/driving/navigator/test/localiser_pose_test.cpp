// SPDX-License-Identifier: Apache-2.0
#include "navigator/localiser_pose.hpp"

#include "foundation/numbers.hpp"
#include "geometry/pose_message.hpp"
#include "navigator_rig.hpp"

namespace tocsin {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(LocaliserPose, IsWhereTheLocaliserSaidAndOdometrySince) {
  LocaliserPose sut{seconds(2)};
  const Time now = Time{} + seconds(100);
  sut.on_odometry(1000 * ms, {1, 0, 0});
  EXPECT_FALSE(sut.pose(now));
  sut.on_odometry(1100 * ms, {1.4, 0, 0});
  sut.on_localiser(1000 * ms, {5, 5, pi / 2}, 0.1, now);
  const auto pose = sut.pose(now);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->x_m, 5, 1e-9);
  EXPECT_NEAR(pose->y_m, 5.4, 1e-9);
  EXPECT_TRUE(sut.pose(now + seconds(2)));
  EXPECT_FALSE(sut.pose(now + seconds(2.1))) << "silent";
}

TEST(LocaliserPose, APoseThatIsNotSureOrHasNoOdometryDoesNotCount) {
  LocaliserPose sut{seconds(2)};
  const Time now = Time{} + seconds(100);
  sut.on_odometry(1000 * ms, {1, 0, 0});
  sut.on_localiser(1000 * ms, {5, 5, 0}, 0.6, now);
  EXPECT_FALSE(sut.pose(now));
  sut.on_localiser(1000 * ms, {5, 5, 0}, nan, now);
  EXPECT_FALSE(sut.pose(now));
  sut.on_localiser(1000 * ms, {nan, 5, 0}, 0.1, now);
  EXPECT_FALSE(sut.pose(now));
  sut.on_localiser(500 * ms, {5, 5, 0}, 0.1, now);
  EXPECT_FALSE(sut.pose(now));
  sut.on_odometry(1100 * ms, {nan, 0, 0});
  sut.on_localiser(1000 * ms, {5, 5, 0}, 0.1, now);
  EXPECT_TRUE(sut.pose(now));
  sut.on_localiser(1000 * ms, {5, 5, 0}, 0.6, now);
  EXPECT_FALSE(sut.pose(now)) << "sure no more";
}

TEST(LocaliserPose, OdometryThatJumpsWaitsForTheLocaliser) {
  LocaliserPose sut{seconds(2)};
  const Time now = Time{} + seconds(100);
  sut.on_odometry(1000 * ms, {3, 0, 0});
  sut.on_localiser(1000 * ms, {5, 5, 0}, 0.1, now);
  sut.on_odometry(1020 * ms, {0, 0, 0});
  EXPECT_FALSE(sut.pose(now));
  sut.on_localiser(1000 * ms, {5, 5, 0}, 0.1, now);
  EXPECT_FALSE(sut.pose(now)) << "of before the jump";
  sut.on_localiser(1020 * ms, {5, 5, 0}, 0.1, now);
  EXPECT_TRUE(sut.pose(now));
}

TEST(LocaliserPose, OneThatStaysWhereItIsWhileTheVehicleDrivesDoesNotCount) {
  LocaliserPose sut{seconds(2)};
  Time now = Time{} + seconds(100);
  std::int64_t stamp_ns = 1000 * ms;
  double odom_m = 0;
  const auto drive = [&](double by_m, double pose_m) {
    stamp_ns += 100 * ms;
    now += seconds(0.1);
    odom_m += by_m;
    sut.on_odometry(stamp_ns, {odom_m, 0, 0});
    sut.on_localiser(stamp_ns, {pose_m, 3, 0}, 0.1, now);
  };
  for (int i = 0; i < 20; ++i) drive(0.1, 5 + 0.1 * i);
  EXPECT_TRUE(sut.pose(now)) << "it goes with the odometry";
  for (int i = 0; i < 15; ++i) drive(0.1, 6.9);
  EXPECT_FALSE(sut.pose(now));
  for (int i = 0; i < 22; ++i) drive(0, 6.9);
  EXPECT_TRUE(sut.pose(now)) << "a vehicle that stands cannot tell";
}

/// By a localiser that is right, and says how sure it is.
class LocalisedNavigatorTest : public NavigatorComponentTest {
 protected:
  LocalisedNavigatorTest() {
    params_.localisation = PoseSource::localiser;
    start();
  }
  void drive(double s) {
    for (int i = 0; i < std::lround(s * 10); ++i) {
      const std::int64_t ns = bus_.wall_ns(bus_.now());
      auto odom = odometry();
      odom.header().stamp().sec(static_cast<std::int32_t>(ns / 1'000'000'000));
      odom.header().stamp().nanosec(static_cast<std::uint32_t>(ns % 1'000'000'000));
      bus_.publish<topic::Odom>(odom);
      topic::AmclPose::Message pose;
      pose.header(odom.header());
      pose.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(
          {odom_.x_m + 2, odom_.y_m, odom_.heading_rad}));
      pose.pose().covariance()[0] = variance_m2_;
      bus_.publish<topic::AmclPose>(pose);
      sut_->tick(bus_.now());
      bus_.run_for(seconds(0.1));
      for (const auto& command : commands_.take()) command_ = command;
      odom_ = compose(odom_, {command_.linear().x() * 0.1, 0, command_.angular().z() * 0.1});
      for (const auto& status : statuses_.take()) status_ = status;
    }
  }
  double variance_m2_ = 0.001;
};

TEST_F(LocalisedNavigatorTest, DrivesByItsLocaliserAndStandsWhileThatIsNotSure) {
  drive(1);
  send_goal(1, 4);
  drive(2);
  EXPECT_EQ(status_.state(), "driving");
  EXPECT_EQ(locations_.take().back().pose().covariance()[0], 0.001) << "the station is told, too";
  variance_m2_ = 1;
  drive(0.8);
  EXPECT_EQ(status_.state(), "held");
  EXPECT_EQ(command_.linear().x(), 0);
  variance_m2_ = 0.001;
  drive(12);
  EXPECT_EQ(status_.state(), "reached");
  EXPECT_NEAR(odom_.x_m, 2, 0.2) << "the map's 4";
}

}  // namespace
}  // namespace tocsin
