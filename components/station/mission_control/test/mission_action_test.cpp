// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_action.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "mission_control_fixture.hpp"
#include "navigation/map_loader.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = WaypointsEnd::Kind;
using State = MissionControl::State;

WaypointsGoal goal_at(const std::vector<double>& xs) {
  WaypointsGoal goal;
  for (const double x : xs) goal.poses.push_back({"map", {x, 0, 0}});
  return goal;
}

/// An action and an idle mission control, whose vehicle stands at 0.
class MissionActionTest : public ::testing::Test {
 protected:
  MissionActionTest() {
    control_.on_location({0, 0, 0}, now_);
    hear({}, "idle");
  }
  std::string begin(const WaypointsGoal& goal) { return sut.begin(goal, control_); }
  std::optional<MissionControl::Goal> after(double s) {
    now_ += seconds(s);
    return control_.update(now_);
  }
  void hear(const GoalName& goal, const char* state) { control_.on_status(goal, state, now_); }
  void arrive_at(double x) {
    control_.on_location({x, 0, 0}, now_);
    (void)after(0.2);
  }
  std::optional<WaypointsEnd> end() { return sut.end(control_, now_); }
  std::uint32_t current() { return sut.current(control_, now_); }
  State state() { return control_.progress(now_).state; }

  Time now_ = t0;
  MissionControl control_{{}, std::nullopt, 1};
  MissionAction sut;
};

TEST_F(MissionActionTest, LeadsThroughItsPosesAtOnceAndEndsWithTheLast) {
  EXPECT_EQ(begin(goal_at({1, 5})), "");
  const auto first = after(0.2).value();
  EXPECT_EQ(first.pose.x_m, 1);
  EXPECT_EQ(first.ahead.size(), 1U);
  EXPECT_EQ(current(), 0U);
  arrive_at(1);
  EXPECT_EQ(current(), 1U);
  EXPECT_FALSE(end());
  arrive_at(5);
  ASSERT_TRUE(end());
  EXPECT_EQ(end()->kind, Kind::succeeded);
  EXPECT_THAT(end()->missed, IsEmpty());
  EXPECT_EQ(end()->reason, "");
}

TEST_F(MissionActionTest, BeginsWithThePoseThatItNames) {
  auto goal = goal_at({1, 5, 9});
  goal.first = 2;
  EXPECT_EQ(begin(goal), "");
  EXPECT_EQ(after(0.2)->pose.x_m, 9);
  EXPECT_EQ(current(), 2U);
}

TEST_F(MissionActionTest, GoesRoundAsOftenAsItSaysFromTheFirstPoseOn) {
  auto goal = goal_at({1, 5});
  goal.first = 1;
  goal.loops = 1;
  EXPECT_EQ(begin(goal), "");
  EXPECT_EQ(after(0.2)->pose.x_m, 5);
  arrive_at(5);
  EXPECT_EQ(current(), 0U);
  arrive_at(1);
  EXPECT_EQ(current(), 1U);
  EXPECT_FALSE(end());
  arrive_at(5);
  EXPECT_EQ(end()->kind, Kind::succeeded);
}

TEST_F(MissionActionTest, TheSamePosesAgainAreDrivenToAgain) {
  EXPECT_EQ(begin(goal_at({1, 5})), "");
  (void)after(0.2);
  arrive_at(1);
  const auto last = after(3).value();
  hear(last.name, "reached");
  (void)after(0.2);
  ASSERT_EQ(end()->kind, Kind::succeeded);
  EXPECT_EQ(begin(goal_at({1, 5})), "");
  const auto first = after(0.2).value();
  EXPECT_EQ(first.waypoint, 0U);
  EXPECT_NE(first.name.mission, last.name.mission) << "the vehicle would take it for over";
  EXPECT_FALSE(end());
}

TEST_F(MissionActionTest, AnotherTakesItsPlaceWithoutAHalt) {
  EXPECT_EQ(begin(goal_at({1, 5})), "");
  const auto before = after(0.2).value();
  hear(before.name, "driving");
  EXPECT_EQ(begin(goal_at({7})), "");
  const auto next = after(0.2).value();
  EXPECT_EQ(next.pose.x_m, 7);
  EXPECT_NE(next.name.mission, before.name.mission);
  EXPECT_EQ(control_.progress(now_).goals_sent, 1U);
}

TEST_F(MissionActionTest, APausedMissionIsReplaced) {
  EXPECT_EQ(begin(goal_at({1})), "");
  (void)after(0.2);
  control_.obey({MissionOrder::Kind::pause}, now_);
  EXPECT_EQ(begin(goal_at({7})), "");
  EXPECT_EQ(after(0.2)->pose.x_m, 7);
  EXPECT_EQ(state(), State::running);
}

TEST_F(MissionActionTest, SkippedPosesAreMissed) {
  EXPECT_EQ(begin(goal_at({1, 5})), "");
  (void)after(0.2);
  control_.obey({MissionOrder::Kind::skip, 0}, now_);
  (void)after(0.2);
  arrive_at(5);
  EXPECT_EQ(end()->kind, Kind::succeeded);
  EXPECT_THAT(end()->missed, ElementsAre(0));
}

TEST_F(MissionActionTest, APoseThatIsBlockedIsMissedAndEndsIt) {
  EXPECT_EQ(begin(goal_at({1, 5, 9})), "");
  (void)after(0.2);
  arrive_at(1);
  const auto second = after(3).value();
  hear(second.name, "blocked");
  (void)after(60.1);
  ASSERT_TRUE(end());
  EXPECT_EQ(end()->kind, Kind::aborted);
  EXPECT_THAT(end()->missed, ElementsAre(1));
  EXPECT_EQ(end()->reason, "waypoint 2 is blocked");
}

class CancelTest : public MissionActionTest {
 protected:
  /// Drives from 0 to 5, and is canceled at 2; the goal that has it halt.
  MissionControl::Goal canceled() {
    EXPECT_EQ(begin(goal_at({5})), "");
    first_ = after(0.2).value();
    hear(first_.name, "driving");
    control_.on_location({2, 0, 0}, now_);
    sut.cancel(control_, now_);
    return after(0.2).value();
  }
  MissionControl::Goal first_;
};

TEST_F(CancelTest, HasTheVehicleHaltWhereItIsAndEndsWhenItSaysSo) {
  const auto halt = canceled();
  EXPECT_EQ(state(), State::aborted);
  EXPECT_EQ(halt.pose.x_m, 2);
  EXPECT_GT(halt.name.id, first_.name.id) << "the vehicle obeys the greater id of a mission";
  EXPECT_EQ(halt.name.mission, first_.name.mission);
  EXPECT_TRUE(halt.ahead.empty());
  EXPECT_FALSE(end());
  hear(halt.name, "driving");
  EXPECT_FALSE(end()) << "it has not arrived there";
  hear(halt.name, "reached");
  ASSERT_TRUE(end());
  EXPECT_EQ(end()->kind, Kind::canceled);
  EXPECT_THAT(end()->missed, ElementsAre(0));
  EXPECT_EQ(end()->reason, "canceled");
}

TEST_F(CancelTest, IsToldTheVehicleAgainUntilItAnswers) {
  const auto halt = canceled();
  EXPECT_FALSE(after(2.9));
  EXPECT_EQ(after(0.1)->name.id, halt.name.id);
  hear(halt.name, "reached");
  EXPECT_FALSE(after(3));
}

TEST_F(CancelTest, EndsWithTheLeaseWhenTheVehicleIsNotHeard) {
  (void)canceled();
  (void)after(59.7);  // 59.9 s after the waypoint's goal
  EXPECT_FALSE(end());
  EXPECT_FALSE(after(0.1)) << "nothing is sent when the lease is over";
  EXPECT_EQ(end()->kind, Kind::canceled);
}

TEST_F(CancelTest, EndsWhenTheVehicleDrivesForSomebodyElse) {
  (void)canceled();
  (void)after(0.1);
  hear({77, 1}, "driving");
  EXPECT_EQ(end()->kind, Kind::canceled);
  EXPECT_FALSE(after(3));
}

TEST_F(CancelTest, BeforeTheVehicleWasSentAnythingIsOverAtOnce) {
  EXPECT_EQ(begin(goal_at({5})), "");
  sut.cancel(control_, now_);
  EXPECT_FALSE(after(0.2));
  EXPECT_EQ(end()->kind, Kind::canceled);
}

TEST_F(CancelTest, OfAPausedMissionNeedsNoOtherHalt) {
  EXPECT_EQ(begin(goal_at({5})), "");
  (void)after(0.2);
  control_.obey({MissionOrder::Kind::pause}, now_);
  const auto pause = after(0.2).value();
  hear(pause.name, "reached");
  (void)after(0.2);
  sut.cancel(control_, now_);
  EXPECT_FALSE(after(3));
  EXPECT_EQ(end()->kind, Kind::canceled);
}

TEST_F(CancelTest, AGoalAfterItIsDrivenTo) {
  const auto halt = canceled();
  hear(halt.name, "reached");
  (void)after(0.2);
  EXPECT_EQ(begin(goal_at({9})), "");
  EXPECT_FALSE(sut.is_canceling());
  const auto next = after(0.2).value();
  EXPECT_EQ(next.pose.x_m, 9);
  EXPECT_NE(next.name.mission, halt.name.mission);
}

class RefusedGoalTest : public MissionActionTest {
 protected:
  void expect(const WaypointsGoal& goal, const char* reason) {
    EXPECT_THAT(begin(goal), HasSubstr(reason));
    EXPECT_EQ(state(), State::idle);
  }
};

TEST_F(RefusedGoalTest, HasNoPoseOneThatIsNotFiniteOfAnotherFrameOrTooMany) {
  expect({}, "poses: there is none");
  auto goal = goal_at({1, 5});
  goal.first = 2;
  expect(goal, "goal_index: 2 is outside [0, 1]");
  goal = goal_at({1});
  goal.poses[0].frame = "odom";
  expect(goal, "frame_id: odom is not map");
  expect(goal_at({1, std::numeric_limits<double>::quiet_NaN()}), "poses: one is not finite");
  goal = goal_at({1});
  goal.loops = 4095;
  expect(goal, "poses: with all loops 4096, more than 4095");
  goal.loops = 4294967295;
  expect(goal, "poses: with all loops 4294967296, more than 4095");
  goal.loops = 4094;
  EXPECT_EQ(begin(goal), "");
}

TEST_F(RefusedGoalTest, HasAPoseInAWall) {
  navigation::GrayImage image;
  image.width = 2;
  image.height = 1;
  image.max = 1;
  image.pixels = {0, 1};
  navigation::MapScale scale;
  scale.resolution_m = 2;
  sut = MissionAction(map_from_image(image, scale), 0.18);
  auto goal = goal_at({3, 1});
  for (auto& place : goal.poses) place.pose.y_m = 1;
  expect(goal, "waypoint 2 at (1, 1) is inside a wall (goal of follow_waypoints)");
}

}  // namespace
}  // namespace tocsin
