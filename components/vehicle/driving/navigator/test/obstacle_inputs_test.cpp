// SPDX-License-Identifier: Apache-2.0
/// The component with its laser, on the bus.
#include <gtest/gtest.h>

#include "seeing_navigator.hpp"

namespace tocsin {
namespace {

class ObstacleInputsTest : public SeeingNavigatorTest {};

TEST_F(ObstacleInputsTest, DoesNotDriveThroughAWallThatOnlyTheLaserSees) {
  send_goal(1, 3);
  drive(15);
  EXPECT_LT(odom_.x_m - 1, wall_m_ - 0.2) << "before it, or at its end";
  EXPECT_NE(status_.state(), "reached");
}

TEST_F(ObstacleInputsTest, IsHeldWithoutScans) {
  has_laser_ = false;
  send_goal(1, 3);
  drive(1);
  EXPECT_EQ(status_.state(), "held");
  has_laser_ = true;
  wall_m_ = 4;
  drive(1);
  EXPECT_EQ(status_.state(), "driving");
}

TEST_F(ObstacleInputsTest, GoesRoundWhatABumperHasTouched) {
  wall_m_ = 4;
  send_goal(1, 3);
  drive(3);
  topic::BumperEvents::Message bump;
  bump.bumper(1);
  bump.state(1);
  bus_.publish<topic::BumperEvents>(bump);
  bump.bumper(7);
  bus_.publish<topic::BumperEvents>(bump);  // a side that does not exist
  double farthest_m = 0;
  for (int i = 0; i < 100; ++i) {
    drive(0.2);
    farthest_m = std::max(farthest_m, std::abs(odom_.y_m));
  }
  EXPECT_EQ(status_.state(), "reached");
  EXPECT_GT(farthest_m, 0.15);
}

}  // namespace
}  // namespace tocsin
