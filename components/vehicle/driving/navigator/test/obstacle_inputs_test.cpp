// SPDX-License-Identifier: Apache-2.0
/// The component with its laser, on the bus.
#include <gtest/gtest.h>

#include "seeing_navigator.hpp"

namespace tocsin {
namespace {

class ObstacleInputsTest : public SeeingNavigatorTest {};
for (int i = 0; i < 360; ++i) {
  const double ahead = std::cos(i * degree + pose.heading_rad);
  const double range_m = ahead > 0.1 ? (wall_m_ - pose.x_m) / ahead : infinity;
  message.ranges().push_back(static_cast<float>(range_m));
}
bus_.publish<topic::Scan>(message);
}
void drive(double s) {
  for (int i = 0; i < std::lround(s * 20); ++i) {
    auto message = odometry();
    message.header().stamp(stamp());
    bus_.publish<topic::Odom>(message);
    if (has_laser_ && i % 2 == 0) scan();
    sut_->tick(bus_.now());
    bus_.run_for(seconds(0.05));
    for (const auto& command : commands_.take()) command_ = command;
    odom_ = compose(odom_, {command_.linear().x() * 0.05, 0, command_.angular().z() * 0.05});
    for (const auto& status : statuses_.take()) status_ = status;
  }
}
bool has_laser_ = true;
double wall_m_ = 1.5;
};

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
