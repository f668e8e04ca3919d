// SPDX-License-Identifier: Apache-2.0
#include "navigator/navigator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "foundation/error.hpp"
#include "vehicle.hpp"

namespace tocsin {
namespace {

TEST(Navigator, ReachesAGoalWithinItsTolerance) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(7, {3, 3, 0}), Answer::accepted);
  const auto output = vehicle.run(15);
  EXPECT_EQ(output.status.state, State::reached);
  EXPECT_EQ(output.status.goal_id, 7U);
  EXPECT_LE(vehicle.distance_to({3, 3, 0}), 0.2);
  EXPECT_EQ(output.velocity.linear_mps, 0);
}

TEST(Navigator, IsBusyFromAGoalToItsEnd) {
  Vehicle vehicle;
  EXPECT_FALSE(vehicle.sut.is_busy(vehicle.now));
  ASSERT_EQ(vehicle.send(7, {3, 3, 0}), Answer::accepted);
  EXPECT_TRUE(vehicle.sut.is_busy(vehicle.now));
  (void)vehicle.run(15);
  EXPECT_FALSE(vehicle.sut.is_busy(vehicle.now));
  ASSERT_EQ(vehicle.send(8, {1, 1, 0}), Answer::accepted);
  vehicle.sut.drop_goal(vehicle.now);
  EXPECT_FALSE(vehicle.sut.is_busy(vehicle.now));
  EXPECT_EQ(vehicle.run(3).velocity.linear_mps, 0);
}

TEST(Navigator, StopsWithinTheToleranceEvenWhenTheBaseLags) {
  for (double direction = -3; direction < 3; direction += 0.5) {
    Vehicle vehicle;
    vehicle.lag = 0.8;
    vehicle.pose = {1.5, 1.5, 0};
    const geometry::Pose goal{1.5 + std::cos(direction), 1.5 + std::sin(direction), 0};
    const Time later = vehicle.now + seconds(60);
    ASSERT_EQ(vehicle.sut.on_goal({1, 1, {goal}, 0.1, later, {}}, vehicle.now), Answer::accepted);
    EXPECT_EQ(vehicle.run(20).status.state, State::reached);
    EXPECT_LE(vehicle.distance_to(goal), 0.1) << direction;
  }
}

TEST(Navigator, DoesNotCountAsArrivedWhileItIsFast) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  while (vehicle.distance_to({3, 1, 0}) > 0.15) (void)vehicle.step();
  const auto output = vehicle.step();
  ASSERT_GT(vehicle.distance_to({3, 1, 0}), 0.075);
  EXPECT_EQ(output.status.state, State::driving);
}

TEST(Navigator, TurnsToTheGoalsHeadingUnlessToldToLeaveIt) {
  for (const bool aligns : {true, false}) {
    Navigator::Params params;
    params.align_yaw = aligns;
    Vehicle vehicle(params);
    ASSERT_EQ(vehicle.send(7, {3, 1, -2.5}), Answer::accepted);
    EXPECT_EQ(vehicle.run(15).status.state, State::reached);
    EXPECT_NEAR(vehicle.pose.heading_rad, aligns ? -2.5 : 0, 0.25);
  }
}

TEST(Navigator, DrivesRoundAWallWithoutTouchingIt) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  for (int i = 0; i < 600; ++i) {
    (void)vehicle.step();
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x_m, vehicle.pose.y_m, 0.18));
  }
  EXPECT_LE(vehicle.distance_to({6, 1, 0}), 0.2);
}

TEST(Navigator, TellsTheDistanceAlongThePath) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  const auto output = vehicle.step();
  EXPECT_EQ(output.status.state, State::driving);
  EXPECT_NEAR(output.status.distance_m, 2, 0.05);
}

TEST(Navigator, RefusesAnOlderGoal) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(2, {3, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.send(1, {1, 3, 0}), Answer::superseded);
  EXPECT_EQ(vehicle.run(15).status.goal_id, 2U);
  EXPECT_EQ(vehicle.send(1, {1, 3, 0}), Answer::superseded);
}

TEST(Navigator, DrivesToTheGoalOfAnotherMissionThoughItHasTheSameId) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  ASSERT_EQ(vehicle.run(15).status.state, State::reached);
  vehicle.mission = 8;
  ASSERT_EQ(vehicle.send(1, {1, 3, 0}), Answer::accepted);
  const auto status = vehicle.run(0.1).status;
  EXPECT_EQ(status.state, State::driving);
  EXPECT_EQ(status.mission, 8U);
  EXPECT_EQ(status.goal_id, 1U);
}

TEST(Navigator, RefusesAGoalThatExpiresNow) {
  Vehicle vehicle;
  EXPECT_EQ(vehicle.send(1, {3, 1, 0}, 0), Answer::expired);
  EXPECT_EQ(vehicle.send(1, {3, 1, 0}, 1e-9), Answer::accepted);
}

TEST(Navigator, RefusesGoalsThatMakeNoSense) {
  Vehicle vehicle;
  struct {
    std::uint64_t id;
    geometry::Pose pose;
    double tolerance_m;
  } const bad[] = {{0, {1, 1, 0}, 0.2}, {1, {nan, 1, 0}, 0.2}, {1, {1, 1, nan}, 0.2},
                   {1, {1, 1, 0}, nan}, {1, {1, 1, 0}, 0.049}, {1, {1, 1, 0}, 5.01}};
  for (const auto& [id, pose, tolerance_m] : bad) {
    EXPECT_EQ(vehicle.sut.on_goal({1, id, {pose}, tolerance_m, t0 + seconds(9), {}}, t0),
              Answer::invalid);
  }
  EXPECT_EQ(vehicle.run(1).status.state, State::idle);
}

TEST(Navigator, HoldsWhenTheGoalExpires) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 2), Answer::accepted);
  EXPECT_EQ(vehicle.run(1.95).status.state, State::driving);
  EXPECT_EQ(vehicle.step().status.state, State::held);
  const auto output = vehicle.run(2);
  EXPECT_EQ(output.status.reason, std::string("goal_expired"));
  EXPECT_EQ(output.velocity.linear_mps, 0);
}

TEST(Navigator, DrivesOnWhenTheGoalIsRenewedWhichNeverShortensIt) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 2), Answer::accepted);
  (void)vehicle.run(5);
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 100), Answer::renewed);
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 1), Answer::renewed);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, StaysReachedWhenTheGoalExpiresAfterwards) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {1.05, 1, 0}, 2), Answer::accepted);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, GoesOnToTheNextGoalOfItsListByItself) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send_list(7, {{2, 1, 0}, {2, 3, 0}}), Answer::accepted);
  while (vehicle.step().status.state != State::reached) ASSERT_LT(vehicle.now, t0 + seconds(20));
  EXPECT_EQ(vehicle.step().status.goal_id, 8U);
  const auto output = vehicle.run(15);
  EXPECT_EQ(output.status.state, State::reached);
  EXPECT_EQ(output.status.goal_id, 8U);
  EXPECT_LE(vehicle.distance_to({2, 3, 0}), 0.2);
}

TEST(Navigator, StaysAtAGoalWhenTheLeaseOfTheNextOneIsOver) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send_list(7, {{1.3, 1, 0}, {2, 3, 0}}, 20), Answer::accepted);
  vehicle.sut.on_emergency_stop(true);
  (void)vehicle.run(17);
  vehicle.sut.on_emergency_stop(false);
  const auto output = vehicle.run(10);
  EXPECT_EQ(output.status.state, State::held);
  EXPECT_EQ(output.status.goal_id, 8U);
  EXPECT_EQ(output.velocity.linear_mps, 0);
}

TEST(Navigator, DoesNotGoOnWhileTheLinkIsLostWhenItIsToHold) {
  Vehicle vehicle(on_link_lost(OnLinkLost::hold));
  ASSERT_EQ(vehicle.send_list(7, {{1.3, 1, 0}, {2, 3, 0}}), Answer::accepted);
  vehicle.sut.on_emergency_stop(true);
  (void)vehicle.run(10.1);
  vehicle.sut.on_emergency_stop(false);
  EXPECT_EQ(vehicle.run(5).status.goal_id, 7U);
  vehicle.sut.on_ground_station(vehicle.now);
  while (vehicle.step().status.goal_id != 8U) ASSERT_LT(vehicle.now, t0 + seconds(60));
}

TEST(Navigator, RefusesContradictingParameters) {
  Navigator::Params params;
  params.follower.turn_done_rad = 2;
  EXPECT_THROW(Navigator(params, floor_with_wall(1)), ConfigError);
}

/// The link is lost from x = 2 to 5.5.
void lose_link(Vehicle& vehicle) {
  const Grid grid{16, 8, 0.5, {0, 0}};
  std::vector<std::int8_t> percent;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const double x_m = grid.centre({column, row}).x_m;
      percent.push_back(x_m > 2 && x_m < 5.5 ? 98 : 1);
    }
  }
  vehicle.sut.set_link({grid, percent});
}

Navigator::Params reconnecting() {
  Navigator::Params params = on_link_lost(OnLinkLost::reconnect);
  params.link_lost_after_s = 2;
  return params;
}

TEST(Navigator, DrivesWhereItIsHeardAgainAndThenOnToItsGoal) {
  Vehicle vehicle(reconnecting(), 0);
  lose_link(vehicle);
  vehicle.pose = {3, 3, 0};
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  const auto away = vehicle.run(7);
  EXPECT_EQ(away.status.state, State::held);
  EXPECT_EQ(std::string(away.status.reason), "link_lost");
  EXPECT_LT(vehicle.pose.x_m, 2.2) << "the nearest place with a link";
  vehicle.sut.on_ground_station(vehicle.now);
  (void)vehicle.run(1);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
  EXPECT_EQ(vehicle.run(20).status.state, State::reached) << "it is not turned back twice";
}

TEST(Navigator, GivesUpBeingHeardAndHolds) {
  Navigator::Params params = reconnecting();
  params.reconnection.reconnect_within_m = 4;
  Vehicle vehicle(params, 0);
  lose_link(vehicle);
  ASSERT_EQ(vehicle.send(1, {4, 1, 0}), Answer::accepted);
  (void)vehicle.run(120);
  const geometry::Pose before = vehicle.pose;
  const auto output = vehicle.run(20);
  EXPECT_EQ(output.status.state, State::held);
  EXPECT_LT(vehicle.distance_to(before), 0.01);
  vehicle.sut.on_ground_station(vehicle.now);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

TEST(Navigator, ReturnsWhereItDoesNotKnowTheLink) {
  Vehicle vehicle(reconnecting(), 0);
  ASSERT_EQ(vehicle.send(1, {7, 1, 0}), Answer::accepted);
  (void)vehicle.run(6);
  ASSERT_GT(vehicle.pose.x_m, 1.3);
  (void)vehicle.run(15);
  EXPECT_LE(vehicle.distance_to({1, 1, 0}), 0.25);
}

TEST(Navigator, AnExpiredGoalIsNoReasonToStayUnheard) {
  Vehicle vehicle(reconnecting(), 0);
  lose_link(vehicle);
  vehicle.pose = {3.5, 2, 0};
  ASSERT_EQ(vehicle.send(1, {3.5, 3, 0}, 3), Answer::accepted);
  (void)vehicle.run(12);
  EXPECT_LT(vehicle.pose.x_m, 2.2);
}

TEST(Navigator, ASecondLossWithAnExpiredGoalLeadsToAnotherPlace) {
  Vehicle vehicle(reconnecting(), 0);
  lose_link(vehicle);
  vehicle.pose = {3.5, 2, 0};
  ASSERT_EQ(vehicle.send(1, {3.5, 3, 0}, 3), Answer::accepted);
  (void)vehicle.run(12);
  ASSERT_LT(vehicle.pose.x_m, 2.2) << "it stands at the place";
  vehicle.sut.on_ground_station(vehicle.now);
  (void)vehicle.run(1);
  vehicle.pose = {3.5, 2, 0};  // somebody has carried it back
  (void)vehicle.run(12);
  EXPECT_LT(vehicle.pose.x_m, 2.2);
}

TEST(Navigator, StandsOnEmergencyStopOnItsWayToBeHeard) {
  Vehicle vehicle(reconnecting(), 0);
  lose_link(vehicle);
  vehicle.pose = {3.5, 2, 0};
  ASSERT_EQ(vehicle.send(1, {5, 2, 0}), Answer::accepted);
  (void)vehicle.run(4);
  vehicle.sut.on_emergency_stop(true);
  const auto output = vehicle.step();
  EXPECT_EQ(output.velocity.linear_mps, 0);
  EXPECT_EQ(std::string(output.status.reason), "emergency_stop");
}

}  // namespace
}  // namespace tocsin
