// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace tocsin::kobuki {
namespace {

/// Drives for `duration_s` in steps of 5 ms; the velocity of the last step.
geometry::Twist drive(Body& sut, const geometry::Twist& velocity, double duration_s) {
  geometry::Twist real;
  for (int i = 0; i < std::lround(duration_s / 0.005); ++i) real = sut.move(velocity, 0.005);
  return real;
}

Body facing_wall(double wall_x_m) { return Body(walled({{wall_x_m, -5, wall_x_m, 5, 0}}), {}); }

TEST(Body, MovesFreelyOnAnOpenFloor) {
  Body sut{open_floor(), {1, 2, pi / 2}};
  drive(sut, {0.5, 0}, 2);
  EXPECT_NEAR(sut.pose().x_m, 1, 1e-9);
  EXPECT_NEAR(sut.pose().y_m, 3, 1e-9);
  EXPECT_FALSE(sut.blocked());
}

TEST(Body, EndsAnArcAtTheSamePlaceInOneMoveAsInMany) {
  Body one{open_floor(), {}};
  Body many{open_floor(), {}};
  one.move({0.5, 3.2}, 0.02);
  for (int i = 0; i < 20; ++i) many.move({0.5, 3.2}, 0.001);
  EXPECT_NEAR(one.pose().x_m, many.pose().x_m, 1e-8);
  EXPECT_NEAR(one.pose().y_m, many.pose().y_m, 1e-8);
  EXPECT_NEAR(one.pose().heading_rad, 0.064, 1e-12);
}

TEST(Body, MovesInShortStepsNearAWallAndInLongOnesElsewhere) {
  for (const double gap_m : {0.20, 0.30}) {  // beside the body, while it goes along the wall
    Body sut(walled({{-5, body_radius_m + gap_m, 5, body_radius_m + gap_m, 0}}), {});
    EXPECT_EQ(sut.longest_move(), std::chrono::milliseconds(5));  // it has not looked yet
    sut.move({0.1, 0}, 0.005);
    EXPECT_EQ(sut.longest_move(), std::chrono::milliseconds(gap_m > 0.26 ? 20 : 5)) << gap_m;
    sut.place({0, -3, 0});
    EXPECT_EQ(sut.longest_move(), std::chrono::milliseconds(5));
  }
}

TEST(Body, IsNeverStoppedByTheEndOfALongMove) {
  Body sut(walled({{5, -5, 5, 5, 0}}), {});
  while (!sut.blocked()) {
    const Duration longest = sut.longest_move();
    sut.move({1.0, 0}, to_seconds(longest));
    EXPECT_TRUE(!sut.blocked() || longest == std::chrono::milliseconds(5));
  }
  EXPECT_EQ(sut.bumper(), centre_bit);
}

TEST(Body, StopsAtAWallAndPressesItsBumperFromWhereverItComes) {
  for (const double start_m : {-3.0, 0.0, 0.3, 0.55, 0.7}) {
    Body sut(walled({{1, -5, 1, 5, 0}}), {start_m, 0, 0});
    EXPECT_EQ(drive(sut, {0.5, 0}, 9).linear_mps, 0);
    EXPECT_TRUE(sut.blocked());
    EXPECT_EQ(sut.bumper(), centre_bit);
    EXPECT_LE(sut.pose().x_m, 1 - body_radius_m + 1e-9) << start_m;
    EXPECT_GT(sut.pose().x_m, 1 - body_radius_m - 0.005) << start_m;
    EXPECT_EQ(drive(sut, {0.5, 0.2}, 1).linear_mps, 0) << "it turns while blocked";
    EXPECT_NEAR(sut.pose().heading_rad, 0.2, 1e-9);
    drive(sut, {-0.1, 0}, 1);
    EXPECT_FALSE(sut.blocked());
    EXPECT_EQ(sut.bumper(), 0);
  }
}

TEST(Body, MeetsAWallAfterItWasPlacedElsewhere) {
  Body sut = facing_wall(1);
  drive(sut, {0.5, 0}, 0.1);
  sut.place({0.8, 0, 0});
  drive(sut, {0.5, 0}, 0.1);
  EXPECT_TRUE(sut.blocked());
  EXPECT_EQ(sut.bumper(), centre_bit);
}

TEST(Body, IsStoppedBackwardsWithoutABumper) {
  Body sut{walled({{-1, -5, -1, 5, 0}}), {}};
  drive(sut, {-0.5, 0}, 4);
  EXPECT_TRUE(sut.blocked());
  EXPECT_EQ(sut.bumper(), 0);
}

TEST(Body, PressesTheSectorTowardsTheObstacle) {
  for (const auto& [bearing_deg, bit] : {std::pair(0.0, +centre_bit),
                                         {29.9, centre_bit},
                                         {30.1, left_bit},
                                         {89.9, left_bit},
                                         {90.1, 0},
                                         {-30.1, right_bit},
                                         {-90.1, 0},
                                         {180.0, 0}}) {
    EXPECT_EQ(bumper_bit(bearing_deg * degree), bit) << bearing_deg;
  }
}

TEST(Body, PressesTwoSectorsInACorner) {
  Body sut{walled({{1, -5, 1, 5, 0}, {-5, 1, 5, 1, 0}}), {0.5, 0.5, pi / 4}};
  drive(sut, {0.3, 0}, 4);
  EXPECT_EQ(sut.bumper(), left_bit | right_bit);
}

}  // namespace
}  // namespace tocsin::kobuki
