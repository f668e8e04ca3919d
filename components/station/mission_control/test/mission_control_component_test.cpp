// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mission_control_component_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

TEST_F(MissionControlComponentTest, PublishesAllWaypointsOnceForEachMission) {
  start();
  run(10);
  const auto paths = paths_.take();
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].header().frame_id(), "map");
  ASSERT_EQ(paths[0].poses().size(), 2U);
  EXPECT_EQ(paths[0].poses()[1].pose().position().x(), 3);
  EXPECT_EQ(paths[0].poses()[1].pose().orientation().w(), 1);
}

TEST_F(MissionControlComponentTest, PublishesAnEmptyPathWithoutAMission) {
  params_.mission_file = "";
  start();
  run(1);
  const auto paths = paths_.take();
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_TRUE(paths[0].poses().empty());
}

TEST_F(MissionControlComponentTest, SendsTheFirstWaypointAsAGoal) {
  const auto goal = first_goal();
  EXPECT_EQ(goal.waypoint(), 0U);
  EXPECT_EQ(goal.x(), 1);
  EXPECT_EQ(goal.y(), 0.5);
  EXPECT_EQ(goal.lifetime_s(), 60);
  ASSERT_EQ(goal.ahead().size(), 1U);
  EXPECT_EQ(goal.ahead()[0].x(), 3);
  EXPECT_EQ(goal.stamp().sec(), 1'767'225'602);
  EXPECT_EQ(state(), "running");
}

TEST_F(MissionControlComponentTest, TellsTheVehicleWhereToStandAndSend) {
  params_.mission_file =
      write("sends.yaml", "waypoints: [{x: 1, y: 0.5, send_s: 40}, {x: 3, y: 0.5, send_s: 5}]\n");
  const auto goal = first_goal();
  EXPECT_EQ(goal.send_s(), 40);
  ASSERT_EQ(goal.ahead().size(), 1U);
  EXPECT_EQ(goal.ahead()[0].send_s(), 5);
}

TEST_F(MissionControlComponentTest, SkipsAWaypointAndIgnoresOtherWords) {
  (void)first_goal();
  for (const char* words : {"skip", "skip 0", "skip 1x", "Pause", ""}) say(words);
  run(0.3);
  EXPECT_EQ(state(), "running");
  EXPECT_TRUE(goals_.take().empty());
  say("skip 1");
  run(0.3);
  EXPECT_EQ(goals_.take().at(0).waypoint(), 1U);
}

TEST_F(MissionControlComponentTest, ReportsOnceASecond) {
  const auto goal = first_goal();
  const auto run_heard = [&](int s) {
    for (; s > 0; --s) {
      tell(goal, "driving");
      run(1);
    }
  };
  run_heard(1);
  statuses_.take();
  run_heard(5);
  EXPECT_EQ(statuses_.take().size(), 5U);
}

TEST_F(MissionControlComponentTest, EndsTheProcessWhenToldSo) {
  params_.exit_when_over = true;
  (void)first_goal();
  locate(1);
  run(0.3);
  EXPECT_FALSE(exit_code_);
  locate(3);
  run(0.3);
  EXPECT_EQ(exit_code_, 0);
}

TEST_F(MissionControlComponentTest, EndsTheProcessWithOneWhenAborted) {
  params_.exit_when_over = true;
  params_.control.blocked_limit_s = 1;
  tell(first_goal(), "blocked");
  run(2);
  EXPECT_EQ(state(), "aborted");
  EXPECT_EQ(exit_code_, 1);
}

TEST_F(MissionControlComponentTest, RefusesAWaypointInAWall) {
  params_.map_file = write_map(true);
  EXPECT_THAT(error_of_start(), HasSubstr("waypoint 1 at (1, 0.5) is inside a wall"));
  params_.map_file = write_map(false);
  EXPECT_EQ(error_of_start(), "no error");
}

TEST_F(MissionControlComponentTest, RefusesToStartWithAMissionThatCannotBeRead) {
  params_.mission_file = "/nowhere/m.yaml";
  EXPECT_THAT(error_of_start(), HasSubstr("/nowhere/m.yaml"));
}

TEST_F(MissionControlComponentTest, IsIdleWithoutAMission) {
  params_.mission_file = "";
  params_.exit_when_over = true;
  start();
  locate(0);
  run(10);
  EXPECT_TRUE(goals_.take().empty());
  EXPECT_FALSE(exit_code_);
  const auto statuses = statuses_.take();
  ASSERT_FALSE(statuses.empty());
  EXPECT_EQ(statuses.back().state(), "idle");
  EXPECT_EQ(statuses.back().mission(), "none");
  EXPECT_EQ(statuses.back().waypoints(), 0U);
}

}  // namespace
}  // namespace tocsin
