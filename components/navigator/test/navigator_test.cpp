// SPDX-License-Identifier: Apache-2.0
#include "navigator/navigator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using navigation::Cell;
using navigation::Grid;
using navigation::OccupancyMap;
using navigation::Pose2;
using State = Navigator::State;
using Answer = Navigator::GoalAnswer;

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration period = std::chrono::milliseconds(50);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// 8 m x 4 m; a wall at x = 4 from y = 0 to `wall_m`.
OccupancyMap floor_with_wall(double wall_m) {
  const Grid grid{160, 80, 0.05, {0, 0}};
  std::vector<Cell> cells(grid.size(), Cell::free);
  for (int row = 0; row < static_cast<int>(wall_m / 0.05); ++row) {
    cells[grid.offset({80, row})] = Cell::occupied;
  }
  return {grid, cells};
}

/// A navigator in a vehicle that does what it is told, at once unless it lags, never when jammed.
class Vehicle {
 public:
  explicit Vehicle(const Navigator::Params& params = {}, double wall_m = 2.0)
      : map(floor_with_wall(wall_m)), sut(params, map) {}

  /// One control period.
  Navigator::Output step() {
    now += period;
    if (has_localisation) sut.on_pose(pose, now);
    const auto output = sut.update(now);
    driven.v_mps += (1 - lag) * (output.velocity.v_mps - driven.v_mps);
    driven.w_radps += (1 - lag) * (output.velocity.w_radps - driven.w_radps);
    if (!is_jammed) pose = compose(pose, {driven.v_mps * 0.05, 0, driven.w_radps * 0.05});
    return output;
  }
  Navigator::Output run(double s) {
    Navigator::Output output;
    for (int i = 0; i < std::lround(s / 0.05); ++i) output = step();
    return output;
  }
  Answer send(std::uint64_t id, const Pose2& to, double lifetime_s = 1000) {
    return sut.on_goal({id, to, 0.15, now + seconds(lifetime_s)}, now);
  }
  double distance_to(const Pose2& to) const { return distance(position(pose), position(to)); }

  OccupancyMap map;
  Navigator sut;
  Time now = t0;
  Pose2 pose{1, 1, 0};
  bool has_localisation = true;
  bool is_jammed = false;
  double lag = 0;  // share of the old velocity that is left after a period
  navigation::Velocity driven;
};

Navigator::Params on_link_lost(const char* what) {
  Navigator::Params params;
  params.on_link_lost = what;
  return params;
}

TEST(Navigator, IsIdleWithoutAGoal) {
  Vehicle vehicle;
  const auto output = vehicle.run(1);
  EXPECT_EQ(output.status.state, State::idle);
  EXPECT_EQ(output.status.goal_id, 0U);
  EXPECT_EQ(output.velocity.v_mps, 0);
}

TEST(Navigator, ReachesAGoalWithinItsTolerance) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(7, {3, 3, 0}), Answer::accepted);
  const auto output = vehicle.run(15);
  EXPECT_EQ(output.status.state, State::reached);
  EXPECT_EQ(output.status.goal_id, 7U);
  EXPECT_LE(vehicle.distance_to({3, 3, 0}), 0.2);
  EXPECT_EQ(output.velocity.v_mps, 0);
}

TEST(Navigator, StopsWithinTheToleranceEvenWhenTheBaseLags) {
  for (double direction = -3; direction < 3; direction += 0.5) {
    Vehicle vehicle;
    vehicle.lag = 0.8;
    vehicle.pose = {1.5, 1.5, 0};
    const Pose2 goal{1.5 + std::cos(direction), 1.5 + std::sin(direction), 0};
    const Time later = vehicle.now + seconds(60);
    ASSERT_EQ(vehicle.sut.on_goal({1, goal, 0.1, later}, vehicle.now), Answer::accepted);
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

TEST(Navigator, TurnsToTheGoalsHeading) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(7, {3, 1, -2.5}), Answer::accepted);
  EXPECT_EQ(vehicle.run(15).status.state, State::reached);
  EXPECT_NEAR(vehicle.pose.yaw, -2.5, 0.25);
}

TEST(Navigator, LeavesTheHeadingAloneWhenToldSo) {
  Navigator::Params params;
  params.align_yaw = false;
  Vehicle vehicle(params);
  ASSERT_EQ(vehicle.send(7, {3, 1, -2.5}), Answer::accepted);
  EXPECT_EQ(vehicle.run(15).status.state, State::reached);
  EXPECT_NEAR(vehicle.pose.yaw, 0, 0.25);
}

TEST(Navigator, DrivesRoundAWallWithoutTouchingIt) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  for (int i = 0; i < 600; ++i) {
    (void)vehicle.step();
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x, vehicle.pose.y, 0.18));
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

TEST(Navigator, ANewerGoalSupersedes) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  (void)vehicle.run(1);
  ASSERT_EQ(vehicle.send(2, {1, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(20).status.goal_id, 2U);
  EXPECT_LE(vehicle.distance_to({1, 3, 0}), 0.2);
}

TEST(Navigator, RefusesAnOlderGoal) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(2, {3, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.send(1, {1, 3, 0}), Answer::superseded);
  EXPECT_EQ(vehicle.run(15).status.goal_id, 2U);
  EXPECT_EQ(vehicle.send(1, {1, 3, 0}), Answer::superseded);
}

TEST(Navigator, RefusesAGoalThatExpiresNow) {
  Vehicle vehicle;
  EXPECT_EQ(vehicle.send(1, {3, 1, 0}, 0), Answer::expired);
  EXPECT_EQ(vehicle.send(1, {3, 1, 0}, 1e-9), Answer::accepted);
}

TEST(Navigator, RefusesGoalsThatMakeNoSense) {
  Vehicle vehicle;
  const Time later = t0 + seconds(9);
  EXPECT_EQ(vehicle.sut.on_goal({0, {1, 1, 0}, 0.2, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.sut.on_goal({1, {nan, 1, 0}, 0.2, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.sut.on_goal({1, {1, 1, nan}, 0.2, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.sut.on_goal({1, {1, 1, 0}, nan, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.sut.on_goal({1, {1, 1, 0}, 0.049, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.sut.on_goal({1, {1, 1, 0}, 5.01, later}, t0), Answer::invalid);
  EXPECT_EQ(vehicle.run(1).status.state, State::idle);
}

TEST(Navigator, HoldsWhenTheGoalExpires) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 2), Answer::accepted);
  EXPECT_EQ(vehicle.run(1.95).status.state, State::driving);
  EXPECT_EQ(vehicle.step().status.state, State::held);
  const auto output = vehicle.run(2);
  EXPECT_EQ(output.status.reason, std::string("goal_expired"));
  EXPECT_EQ(output.velocity.v_mps, 0);
}

TEST(Navigator, DrivesOnWhenTheGoalIsRenewed) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 2), Answer::accepted);
  (void)vehicle.run(5);
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 100), Answer::renewed);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, ARenewalNeverShortensTheLifetime) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 100), Answer::accepted);
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}, 1), Answer::renewed);
  EXPECT_EQ(vehicle.run(2).status.state, State::driving);
}

TEST(Navigator, StaysReachedWhenTheGoalExpiresAfterwards) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {1.05, 1, 0}, 2), Answer::accepted);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, HaltsAtOnceWithoutAFreshPose) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  ASSERT_GT(vehicle.run(1.5).velocity.v_mps, 0.3);
  vehicle.has_localisation = false;
  EXPECT_EQ(vehicle.run(0.5).status.state, State::driving);
  const auto output = vehicle.step();
  EXPECT_EQ(output.status.state, State::held);
  EXPECT_EQ(output.status.reason, std::string("no_pose"));
  EXPECT_EQ(output.velocity.v_mps, 0);
  vehicle.has_localisation = true;
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, HaltsBeforeTheFirstPose) {
  Vehicle vehicle;
  vehicle.has_localisation = false;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(0.2).status.reason, std::string("no_pose"));
}

TEST(Navigator, APoseThatIsNotFiniteIsNoPose) {
  Vehicle vehicle;
  vehicle.pose.x = nan;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(0.2).status.reason, std::string("no_pose"));
}

TEST(Navigator, HaltsAtOnceOnEmergencyStopUntilItIsReleased) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  ASSERT_GT(vehicle.run(1.5).velocity.v_mps, 0.3);
  vehicle.sut.on_emergency_stop(true);
  EXPECT_EQ(vehicle.step().velocity.v_mps, 0);
  ASSERT_EQ(vehicle.send(2, {3, 1, 0}), Answer::accepted);
  const auto output = vehicle.run(100);
  EXPECT_EQ(output.velocity.v_mps, 0);
  EXPECT_EQ(output.status.reason, std::string("emergency_stop"));
  vehicle.sut.on_emergency_stop(false);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
  EXPECT_EQ(vehicle.run(10).status.state, State::reached);
}

TEST(Navigator, DrivesOnThroughALostLinkByDefault) {
  Vehicle vehicle;
  vehicle.sut.on_ground_station(vehicle.now);
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(40).status.state, State::reached);
}

TEST(Navigator, HoldsWhileTheLinkIsLost) {
  Vehicle vehicle(on_link_lost("hold"));
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(10).status.state, State::driving);
  EXPECT_EQ(vehicle.step().status.state, State::held);
  const auto output = vehicle.run(30);
  EXPECT_EQ(output.status.reason, std::string("link_lost"));
  EXPECT_EQ(output.velocity.v_mps, 0);
  vehicle.sut.on_ground_station(vehicle.now);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

TEST(Navigator, ReturnsToWhereItBeganWhileTheLinkIsLost) {
  Vehicle vehicle(on_link_lost("return"));
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
  Vehicle vehicle(on_link_lost("hold"));
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::accepted);
  (void)vehicle.run(9);
  ASSERT_EQ(vehicle.send(1, {7, 3, 0}), Answer::renewed);
  EXPECT_EQ(vehicle.run(2).status.state, State::driving);
}

TEST(Navigator, IsBlockedWhenThereIsNoPath) {
  Vehicle vehicle({}, 4.0);
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  for (int i = 0; i < 400; ++i) {
    const auto output = vehicle.step();
    ASSERT_EQ(output.status.state, State::blocked);
    ASSERT_EQ(output.velocity.v_mps, 0);
  }
  EXPECT_TRUE(std::isnan(vehicle.step().status.distance_m));
}

TEST(Navigator, IsBlockedByAGoalInAWall) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {4.02, 1, 0}), Answer::accepted);
  EXPECT_EQ(vehicle.run(1).status.reason, std::string("no_path"));
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
  EXPECT_LT(vehicle.run(0.5).velocity.v_mps, 0);
  vehicle.is_jammed = false;
  EXPECT_EQ(vehicle.run(12).status.state, State::reached);
}

TEST(Navigator, DoesNotBackUpIntoAWall) {
  Vehicle vehicle;
  vehicle.pose = {4.28, 1, 0};
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  vehicle.is_jammed = true;
  ASSERT_EQ(vehicle.run(4.2).status.reason, std::string("stuck"));
  for (int i = 0; i < 40; ++i) ASSERT_GE(vehicle.step().velocity.v_mps, 0);
}

TEST(Navigator, IsNotStuckAfterALongHold) {
  Vehicle vehicle;
  ASSERT_EQ(vehicle.send(1, {3, 1, 0}), Answer::accepted);
  vehicle.sut.on_emergency_stop(true);
  (void)vehicle.run(60);
  vehicle.sut.on_emergency_stop(false);
  EXPECT_EQ(vehicle.step().status.state, State::driving);
}

/// Drives over the end of the wall and half down its other side, then is put back before it.
void put_back_before_the_wall(Vehicle& vehicle) {
  vehicle.pose = {3, 1, 0};
  ASSERT_EQ(vehicle.send(1, {6, 1, 0}), Answer::accepted);
  while (vehicle.pose.x < 4.8) (void)vehicle.step();
  vehicle.pose = {3, 1.2, 0};
}

TEST(Navigator, PlansAgainWhenItIsFarBesideItsPath) {
  Vehicle vehicle;
  put_back_before_the_wall(vehicle);
  for (int i = 0; i < 600; ++i) {
    ASSERT_NE(vehicle.step().status.state, State::blocked);
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x, vehicle.pose.y, 0.18));
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
    ASSERT_FALSE(vehicle.map.collides(vehicle.pose.x, vehicle.pose.y, 0.17));
  }
  EXPECT_TRUE(was_stuck);
  EXPECT_LE(vehicle.distance_to({6, 1, 0}), 0.2);
}

TEST(Navigator, RefusesContradictingParameters) {
  Navigator::Params params;
  params.follower.turn_done_rad = 2;
  EXPECT_THROW(Navigator(params, floor_with_wall(1)), ConfigError);
}

}  // namespace
}  // namespace tocsin
