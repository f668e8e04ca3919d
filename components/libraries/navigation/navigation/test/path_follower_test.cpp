// SPDX-License-Identifier: Apache-2.0
#include "navigation/path_follower.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foundation/error.hpp"

namespace tocsin::navigation {
namespace {

using namespace std::chrono_literals;

constexpr Duration tick = 50ms;

/// A robot that does at once what it is told.
geometry::Pose moved(const geometry::Pose& pose, const geometry::Twist& velocity) {
  const double dt_s = to_seconds(tick);
  const double yaw = pose.heading_rad + velocity.angular_rad_s * dt_s / 2;
  return {pose.x_m + velocity.linear_mps * dt_s * std::cos(yaw),
          pose.y_m + velocity.linear_mps * dt_s * std::sin(yaw),
          geometry::wrap_angle(pose.heading_rad + velocity.angular_rad_s * dt_s)};
}

struct Drive {
  std::vector<geometry::Pose> poses;
  std::vector<geometry::Twist> velocities;
  double worst_deviation_m = 0;
};

Drive drive(PathFollower& sut, geometry::Pose pose, double until_m, int most_ticks = 2000) {
  Drive result;
  for (int i = 0; i < most_ticks; ++i) {
    const geometry::Twist velocity = sut.follow(pose, tick);
    result.worst_deviation_m = std::max(result.worst_deviation_m, sut.deviation_m());
    pose = moved(pose, velocity);
    result.poses.push_back(pose);
    result.velocities.push_back(velocity);
    if (distance(position(pose), sut.path().back()) <= until_m) break;
  }
  return result;
}

TEST(PathFollower, ReachesTheEndOfPathsInEveryDirection) {
  for (double direction = -3.1; direction <= 3.1; direction += 0.2) {
    PathFollower sut{{}};
    const geometry::Point corner{2 * std::cos(direction), 2 * std::sin(direction)};
    sut.start({{0, 0}, corner, {corner.x_m + 1, corner.y_m + 1}});
    const Drive run = drive(sut, {0, 0, 0.4}, 0.1);
    EXPECT_LE(distance(position(run.poses.back()), sut.path().back()), 0.1) << direction;
    EXPECT_LE(run.worst_deviation_m, 0.25) << direction;
  }
}

TEST(PathFollower, TellsHowFarItIsToTheEndAlongThePath) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {2, 0}, {2, 0}, {2, 3}});
  (void)sut.follow({0.5, 0.1, 0}, tick);
  EXPECT_NEAR(sut.remaining_m(), 4.5, 1e-9);
  EXPECT_NEAR(sut.deviation_m(), 0.1, 1e-9);
  (void)sut.follow({1.4, 0, 0}, tick);
  (void)sut.follow({2.2, 1, 0}, tick);
  EXPECT_NEAR(sut.remaining_m(), 2, 1e-9);
  EXPECT_NEAR(sut.deviation_m(), 0.2, 1e-9);
  sut.start({{2, 1}, {2, 3}});
  (void)sut.follow({2, 2, 0}, tick);
  EXPECT_NEAR(sut.remaining_m(), 1, 1e-9);
}

TEST(PathFollower, KeepsItsSpeedTurnAndAccelerationLimits) {
  FollowerParams params;
  params.speed_mps = 0.4;
  params.turn_rate_radps = 0.8;
  PathFollower sut{params};
  sut.start({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 4}});
  geometry::Twist last;
  for (const geometry::Twist& velocity : drive(sut, {0, 0, 2}, 0.1).velocities) {
    EXPECT_LE(std::abs(velocity.linear_mps), 0.4 + 1e-9);
    EXPECT_LE(std::abs(velocity.angular_rad_s), 0.8 + 1e-9);
    EXPECT_LE(std::abs(velocity.linear_mps - last.linear_mps), 0.5 * 0.05 + 1e-9);
    EXPECT_LE(std::abs(velocity.angular_rad_s - last.angular_rad_s), 3.0 * 0.05 + 1e-9);
    last = velocity;
  }
}

TEST(PathFollower, ReachesItsTopSpeedOnALongStraightAndSlowsBeforeItsEnd) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {5, 0}});
  const Drive run = drive(sut, {0, 0, 0}, 0.05);
  EXPECT_NEAR(run.velocities[run.velocities.size() / 2].linear_mps, 0.5, 1e-9);
  EXPECT_LT(run.velocities.back().linear_mps, 0.25);
  EXPECT_LT(to_seconds(tick) * static_cast<double>(run.poses.size()), 16);
}

TEST(PathFollower, SlowsInTurns) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {3, 0}, {3, 3}});
  double slowest = 1;
  const Drive run = drive(sut, {0, 0, 0}, 1.5);
  for (std::size_t i = 40; i < run.velocities.size(); ++i) {
    slowest = std::min(slowest, run.velocities[i].linear_mps);
  }
  EXPECT_LT(slowest, 0.4);
}

TEST(PathFollower, TurnsInPlaceFromAFarOffHeadingToAGoodOne) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {5, 0}});
  EXPECT_GT(sut.follow({0, 0, 0.89}, tick).linear_mps, 0);
  PathFollower turning{{}};
  turning.start({{0, 0}, {5, 0}});
  const geometry::Twist beyond = turning.follow({0, 0, 0.91}, tick);
  EXPECT_DOUBLE_EQ(beyond.linear_mps, 0);
  EXPECT_LT(beyond.angular_rad_s, 0);
  EXPECT_DOUBLE_EQ(turning.follow({0, 0, 0.26}, tick).linear_mps, 0);
  EXPECT_GT(turning.follow({0, 0, 0.24}, tick).linear_mps, 0);
}

TEST(PathFollower, TurnsTheShorterWayRound) {
  for (const double heading_rad : {2.0, -2.0}) {
    PathFollower sut{{}};
    sut.start({{0, 0}, {-5, 0}});
    EXPECT_GT(sut.follow({0, 0, heading_rad}, tick).angular_rad_s * heading_rad, 0);
  }
}

TEST(PathFollower, DoesNotSkipToALaterStretchNearby) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {4, 0}, {4, 0.5}, {0, 0.5}});
  (void)sut.follow({1, 0.4, 0}, tick);
  EXPECT_NEAR(sut.remaining_m(), 3 + 0.5 + 4, 1e-9);
}

TEST(PathFollower, BrakesWithinTheLimitAndHaltsAtOnce) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {5, 0}});
  for (int i = 0; i < 20; ++i) (void)sut.follow({1, 0, 0}, tick);
  ASSERT_NEAR(sut.velocity().linear_mps, 0.5, 1e-9);
  EXPECT_NEAR(sut.brake(tick).linear_mps, 0.475, 1e-9);
  EXPECT_EQ(sut.halt().linear_mps, 0);
  EXPECT_EQ(sut.velocity().linear_mps, 0);
}

TEST(PathFollower, BacksUpStraight) {
  PathFollower sut{{}};
  geometry::Twist velocity;
  for (int i = 0; i < 10; ++i) velocity = sut.back_up(tick);
  EXPECT_NEAR(velocity.linear_mps, -0.1, 1e-9);
  EXPECT_EQ(velocity.angular_rad_s, 0);
}

TEST(PathFollower, TreatsALongPauseLikeAShortOne) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {5, 0}});
  EXPECT_NEAR(sut.follow({0, 0, 0}, 10s).linear_mps, 0.5 * 0.2, 1e-9);
  EXPECT_NEAR(sut.follow({0, 0, 0}, -1s).linear_mps, 0.5 * 0.2, 1e-9);
}

TEST(PathFollower, TurnsToAHeadingOnTheSpot) {
  PathFollower sut{{}};
  geometry::Pose pose{0, 0, 0};
  for (int i = 0; i < 100; ++i) pose = moved(pose, sut.turn_to(pose, 2.0, tick));
  EXPECT_NEAR(pose.heading_rad, 2.0, 0.02);
  EXPECT_EQ(pose.x_m, 0);
}

TEST(PathFollower, RefusesAHysteresisThatIsUpsideDown) {
  FollowerParams params;
  params.turn_done_rad = 0.9;
  EXPECT_THROW(PathFollower{params}, ConfigError);
  params.turn_done_rad = 0.89;
  EXPECT_NO_THROW(PathFollower{params});
}

TEST(PathFollower, TakesAnotherTopSpeedWithinTheAccelerationLimit) {
  PathFollower sut{{}};
  sut.start({{0, 0}, {20, 0}});
  (void)drive(sut, {0, 0, 0}, 0.05, 100);
  sut.set_speeds(0.2, 1.2);
  const Drive slower = drive(sut, {5, 0, 0}, 0.05, 20);
  EXPECT_NEAR(slower.velocities[0].linear_mps, 0.475, 1e-9);  // 0.5 m/s2 in 50 ms
  EXPECT_NEAR(slower.velocities.back().linear_mps, 0.2, 1e-9);
}

}  // namespace
}  // namespace tocsin::navigation
