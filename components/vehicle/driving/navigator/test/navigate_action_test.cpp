// SPDX-License-Identifier: Apache-2.0
// The action navigate_to_pose of the navigator, by a client on the vehicle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "navigator_rig.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using Drive = action::NavigateToPose;
using What = ActionClient<Drive>::What;

class Driver : public Component {
 public:
  explicit Driver(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (auto one = client.take(now)) news.push_back(*one);
  }
  ActionClient<Drive> client{*this};
  std::vector<ActionClient<Drive>::News> news;
};

class NavigateActionTest : public NavigatorComponentTest {
 protected:
  NavigateActionTest() {
    bus_.add(driver_);
    run(0.2);
  }
  static Drive::Goal goal(double x_m, const char* frame = "map") {
    Drive::Goal made;
    made.pose().header().frame_id(frame);
    made.pose().pose().position().x(x_m);
    made.pose().pose().orientation().w(1);
    return made;
  }
  GoalId send(const Drive::Goal& goal) {
    return driver_.client.send(goal, bus_.now() + seconds(1), bus_.now() + seconds(1000));
  }
  void cancel(const GoalId& id) { driver_.client.cancel(id, bus_.now() + seconds(1)); }
  /// All but feedback.
  std::vector<What> steps(const GoalId& id) {
    std::vector<What> all;
    for (const auto& one : driver_.news) {
      if (one.id == id && one.what != What::feedback) all.push_back(one.what);
    }
    return all;
  }
  const ActionClient<Drive>::News& end(const GoalId& id) {
    for (const auto& one : driver_.news) {
      if (one.id == id && one.what == What::result) return one;
    }
    ADD_FAILURE() << "it has not ended";
    return driver_.news.front();
  }
  Context driver_context_{bus_, "driver", Role::uxv};
  Driver driver_{driver_context_};
};

TEST_F(NavigateActionTest, ANavigatorThatIsRestartedGoesOnWithNoGoalOfAProgram) {
  context_.run_dir = folder_.string();
  start();
  run(0.2);
  send_goal(5, -0.5);
  run(6);
  ASSERT_EQ(status_.state(), "reached");
  (void)send(goal(3));
  run(3);
  ASSERT_EQ(status_.state(), "driving");
  start();
  run(1);
  EXPECT_EQ(status_.state(), "idle");
}

TEST_F(NavigateActionTest, DrivesThereAndTellsHowItGoes) {
  const GoalId id = send(goal(2));
  run(2);
  ASSERT_GE(driver_.news.size(), 4U);
  const auto& on_the_way = *driver_.news.back().feedback;
  EXPECT_EQ(on_the_way.current_pose().header().frame_id(), "map");
  EXPECT_NEAR(on_the_way.current_pose().pose().position().x(), odom_.x_m - 1, 0.2);
  EXPECT_NEAR(on_the_way.distance_remaining(), 3 - odom_.x_m, 0.3);
  EXPECT_NEAR(on_the_way.navigation_time().sec(), 2, 1);
  EXPECT_GT(on_the_way.estimated_time_remaining().sec(), 2);
  run(12);
  EXPECT_THAT(steps(id), ElementsAre(What::accepted, What::result));
  EXPECT_EQ(end(id).state, GoalState::succeeded);
  EXPECT_EQ(end(id).result->error_code(), 0);
  EXPECT_NEAR(odom_.x_m, 3, 0.25);
}

TEST_F(NavigateActionTest, CanceledInTheMiddleItBrakesStandsAndIsCanceled) {
  const GoalId id = send(goal(3));
  run(3);
  ASSERT_GT(command_.linear().x(), 0.3);
  cancel(id);
  run(0.1);
  EXPECT_GT(command_.linear().x(), 0) << "brakes within its acceleration";
  EXPECT_THAT(steps(id), ElementsAre(What::accepted, What::canceling));
  run(2);
  EXPECT_EQ(command_.linear().x(), 0);
  EXPECT_EQ(end(id).state, GoalState::canceled);
  EXPECT_LT(odom_.x_m, 3);
}

TEST_F(NavigateActionTest, WhatCannotBeDrivenToIsRejected) {
  auto with_tree = goal(1);
  with_tree.behavior_tree("tree.xml");
  const std::vector<Drive::Goal> refused{goal(1, "odom"), with_tree,
                                         goal(std::numeric_limits<double>::quiet_NaN())};
  for (const auto& one : refused) {
    const GoalId id = send(one);
    run(0.2);
    EXPECT_THAT(steps(id), ElementsAre(What::rejected));
  }
  EXPECT_EQ(command_.linear().x(), 0);
}

TEST_F(NavigateActionTest, AGoalOfTheGroundStationThatIsDrivenToComesFirst) {
  goal_.mission(5);
  send_goal(1, 2);
  run(0.5);
  const GoalId id = send(goal(-3));
  run(0.2);
  EXPECT_THAT(steps(id), ElementsAre(What::rejected));
  ASSERT_TRUE(driver_.news.back().result);
  EXPECT_EQ(driver_.news.back().result->error_msg(), "a goal of the ground station is driven to");
  EXPECT_EQ(status_.mission(), 5U);
}

TEST_F(NavigateActionTest, IsAcceptedOnceTheGroundStationsGoalIsReachedOrOver) {
  send_goal(1, -0.5);
  run(6);
  ASSERT_EQ(status_.state(), "reached");
  const GoalId reached = send(goal(0));
  run(0.2);
  EXPECT_EQ(steps(reached).front(), What::accepted);
}

TEST_F(NavigateActionTest, AGoalOfTheGroundStationEndsIt) {
  const GoalId id = send(goal(3));
  run(1);
  goal_.mission(5);
  send_goal(1, -2);
  run(0.5);
  EXPECT_EQ(end(id).state, GoalState::aborted);
  EXPECT_EQ(end(id).result->error_msg(), "superseded by another goal");
  EXPECT_NE(end(id).result->error_code(), 0);
  EXPECT_EQ(status_.mission(), 5U);
}

TEST_F(NavigateActionTest, ASecondGoalTakesOverAndTheFirstIsAborted) {
  const GoalId first = send(goal(3));
  run(1);
  const GoalId second = send(goal(0));
  run(10);
  EXPECT_EQ(end(first).state, GoalState::aborted);
  EXPECT_EQ(end(second).state, GoalState::succeeded);
  EXPECT_NEAR(odom_.x_m, 1, 0.25);
}

TEST_F(NavigateActionTest, IsGivenUpAfterItsTime) {
  params_.pose_goal_timeout_s = 3;
  sut_.reset();
  start();
  const GoalId id = send(goal(4));
  run(2.5);
  EXPECT_THAT(steps(id), ElementsAre(What::accepted));
  run(3);
  EXPECT_EQ(end(id).state, GoalState::aborted);
  EXPECT_EQ(end(id).result->error_msg(), "not reached in its time");
  EXPECT_EQ(command_.linear().x(), 0);
}

}  // namespace
}  // namespace tocsin
