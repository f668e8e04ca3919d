// SPDX-License-Identifier: Apache-2.0
// What the navigator does when something fails: pose, link, path, wheels.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "navigator/navigator.hpp"
#include "vehicle.hpp"

namespace tocsin {
namespace {

TEST(Navigator, HaltsAtOnceWithoutAFreshPose) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  ASSERT_GT(vehicle.run(1.5).velocity.linear_mps, 0.3);
  vehicle.has_localisation = false;
  EXPECT_EQ(vehicle.run(0.5).status.state, State::driving);
  const auto output = vehicle.step();
  EXPECT_EQ(output.status.state, State::held);
  EXPECT_EQ(output.status.reason, std::string("no_pose"));
  EXPECT_EQ(output.velocity.linear_mps, 0);
  vehicle.has_localisation = true;
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, APoseThatIsNotFiniteIsNoPose) {
  for (const bool has_localisation : {true, false}) {
    Vehicle vehicle;
    vehicle.pose.x_m = nan;
    vehicle.has_localisation = has_localisation;
    ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
    EXPECT_EQ(vehicle.run(0.2).status.reason, std::string("no_pose"));
  }
}

TEST(Navigator, HaltsAtOnceOnEmergencyStopUntilItIsReleased) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  ASSERT_GT(vehicle.run(1.5).velocity.linear_mps, 0.3);
  vehicle.sut.on_emergency_stop(true);
  EXPECT_EQ(vehicle.step().velocity.linear_mps, 0);
  ASSERT_EQ(vehicle.send(2, {3, 1, 0}), Answer::accepted);
  const auto output = vehicle.run(20);
  EXPECT_EQ(output.velocity.linear_mps, 0);
  EXPECT_EQ(output.status.reason, std::string("emergency_stop"));
  vehicle.sut.on_emergency_stop(false);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, HoldsAfterThirtySecondsWithoutTheGroundStationByDefault) {
  Vehicle vehicle({}, 4.0);  // so that it never arrives
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(30).status.state, State::blocked);
  EXPECT_EQ(vehicle.step().status.reason, std::string("link_lost"));
}

TEST(Navigator, DrivesOnThroughALostLinkWhenItShall) {
  Vehicle vehicle(on_link_lost(OnLinkLost::carry_on));
  vehicle.sut.on_ground_station(vehicle.now);
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(40).status.state, State::reached);
}

TEST(Navigator, HoldsWhileTheLinkIsLost) {
  Vehicle vehicle(on_link_lost(OnLinkLost::hold));
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(10).status.state, State::driving);
  EXPECT_EQ(vehicle.step().status.state, State::held);
  const auto output = vehicle.run(30);
  EXPECT_EQ(output.status.reason, std::string("link_lost"));
  EXPECT_EQ(output.velocity.linear_mps, 0);
  vehicle.sut.on_ground_station(vehicle.now);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

TEST(Navigator, ReturnsToWhereItBeganWhileTheLinkIsLost) {
  Vehicle vehicle(on_link_lost(OnLinkLost::go_home));
  (void)vehicle.step();
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  (void)vehicle.run(9);
  ASSERT_GT(vehicle.distance_to({1, 1, 0}), 2);
  const auto output = vehicle.run(30);
  EXPECT_LE(vehicle.distance_to({1, 1, 0}), 0.25);
  EXPECT_EQ(output.status.state, State::held);
  vehicle.sut.on_ground_station(vehicle.now);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

TEST(Navigator, AGoalCountsAsASignOfTheGroundStation) {
  Vehicle vehicle(on_link_lost(OnLinkLost::hold));
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  (void)vehicle.run(9);
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::renewed);
  EXPECT_EQ(vehicle.run(2).status.state, State::driving);
}

TEST(Navigator, IsBlockedWhenThereIsNoPath) {
  Vehicle vehicle({}, 4.0);
  for (const double x_m : {6.0, 4.02}) {  // behind the wall, in it
    ASSERT_EQ(vehicle.send(static_cast<std::uint64_t>(x_m * 100), {x_m, 1, 0}), Answer::accepted);
    for (int i = 0; i < 400; ++i) {
      const auto output = vehicle.step();
      ASSERT_EQ(output.status.state, State::blocked);
      ASSERT_EQ(output.velocity.linear_mps, 0);
    }
    vehicle.mission += 1;
  }
  EXPECT_TRUE(std::isnan(vehicle.step().status.distance_m));
}

TEST(Navigator, TakesANewGoalWhileItIsBlocked) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {4.02, 1, 0}), Answer::accepted);
  (void)vehicle.run(1);
  ASSERT_EQ(vehicle.send(2, {2, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

TEST(Navigator, BacksUpAndTriesAgainWhenItIsStuck) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  vehicle.is_jammed = true;
  EXPECT_EQ(vehicle.run(4).status.state, State::driving);
  EXPECT_EQ(vehicle.run(0.2).status.reason, std::string("stuck"));
  EXPECT_LT(vehicle.run(0.5).velocity.linear_mps, 0);
  vehicle.is_jammed = false;
  EXPECT_EQ(vehicle.run(12).status.state, State::reached);
}

TEST(Navigator, DoesNotBackUpIntoAWall) {
  Vehicle vehicle;
  vehicle.pose = {4.28, 1, 0};
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  vehicle.is_jammed = true;
  ASSERT_EQ(vehicle.run(4.2).status.reason, std::string("stuck"));
  for (int i = 0; i < 40; ++i) ASSERT_GE(vehicle.step().velocity.linear_mps, 0);
}

TEST(Navigator, IsNotStuckAfterALongHold) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  vehicle.sut.on_emergency_stop(true);
  (void)vehicle.run(20);
  vehicle.sut.on_emergency_stop(false);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

/// Drives over the end of the wall and half down its other side, then is put back before it.
void put_back_before_the_wall(Vehicle& vehicle) {
  vehicle.pose = {3, 1, 0};
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  while (vehicle.pose.x_m < 4.8) (void)vehicle.step();
  vehicle.pose = {3, 1.2, 0};
}

TEST(Navigator, PlansAgainWhenItIsFarBesideItsPath) {
  Vehicle vehicle;
  put_back_before_the_wall(vehicle);
  for (int i = 0; i < 600; ++i) {
    ASSERT_NE(vehicle.step().status.state, State::blocked);
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x_m, vehicle.pose.y_m, 0.18));
  }
  EXPECT_LE(vehicle.distance_to({6, 1, 0}), 0.2);
}

TEST(Navigator, StopsBeforeAWallThatIsInItsWayAndPlansAgain) {
  Navigator::Params params;
  params.replan_beside_m = 5;
  Vehicle vehicle(params);
  put_back_before_the_wall(vehicle);
  bool was_stuck = false;
  for (int i = 0; i < 1000; ++i) {
    was_stuck = vehicle.step().status.state == State::blocked || was_stuck;
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x_m, vehicle.pose.y_m, 0.17));
  }
  EXPECT_TRUE(was_stuck);
  EXPECT_LE(vehicle.distance_to({6, 1, 0}), 0.2);
}

}  // namespace
}  // namespace tocsin
