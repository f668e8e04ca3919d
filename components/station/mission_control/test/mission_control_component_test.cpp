// SPDX-License-Identifier: Apache-2.0
#include "mission_control/mission_control_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class MissionControlComponentTest : public ::testing::Test {
 protected:
  MissionControlComponentTest() {
    std::filesystem::create_directories(folder_);
    params_.mission_file =
        write("two.yaml", "name: two\nwaypoints: [{x: 1, y: 0.5}, {x: 3, y: 0.5}]\n");
    context_.request_exit = [this](int code) { exit_code_ = code; };
  }
  ~MissionControlComponentTest() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  /// A floor of 4 m x 1 m whose left half is a wall, or free.
  std::string write_map(bool has_wall) const {
    write("m.pgm", "P2 2 1 1\n" + std::string(has_wall ? "0" : "1") + " 1\n");
    return write("m.yaml", "image: m.pgm\nresolution: 2\norigin: [0, 0, 0]\n");
  }
  void start() {
    sut_ = std::make_unique<MissionControlComponent>(context_, params_);
    bus_.add(*sut_);
  }
  std::string error_of_start() {
    try {
      start();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  void locate(double x) {
    topic::Location::Message message;
    message.pose().pose().position().x(x);
    message.pose().pose().position().y(0.5);
    message.pose().pose().orientation().w(1);
    bus_.publish<topic::Location>(message);
  }
  void tell(const topic::Goal::Message& goal, const char* state) {
    topic::NavigationStatus::Message message;
    message.goal_id(goal.id());
    message.mission(goal.mission());
    message.state(state);
    bus_.publish<topic::NavigationStatus>(message);
  }
  void say(const char* words) {
    topic::MissionCommand::Message message;
    message.data(words);
    bus_.publish<topic::MissionCommand>(message);
    run(0.05);  // the next words would take their place
  }
  void run(double s) { bus_.run_for(seconds(s)); }
  topic::Goal::Message first_goal() {
    start();
    run(0.1);
    locate(0);
    run(2.5);
    return goals_.take().at(0);
  }
  std::string state() {
    const auto statuses = statuses_.take();
    return statuses.empty() ? "none" : statuses.back().state();
  }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                        ("tocsin_mission_control_" + std::to_string(::getpid()));
  SimBus bus_;
  Context context_{bus_, "mission_control", Role::gcs};
  MissionControlComponent::Params params_;
  std::unique_ptr<MissionControlComponent> sut_;
  SimReader<topic::Goal> goals_{bus_};
  SimReader<topic::MissionStatus> statuses_{bus_};
  std::optional<int> exit_code_;
};

TEST_F(MissionControlComponentTest, WaitsForTheVehicle) {
  start();
  run(10);
  EXPECT_TRUE(goals_.take().empty());
  EXPECT_EQ(state(), "waiting");
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

TEST_F(MissionControlComponentTest, LeadsThroughTheMissionByLocationAndStatus) {
  (void)first_goal();
  locate(1);
  run(0.3);
  const auto second = goals_.take().at(0);
  EXPECT_EQ(second.waypoint(), 1U);
  tell(second, "reached");
  run(0.3);
  EXPECT_EQ(state(), "done");
  EXPECT_TRUE(goals_.take().empty());
}

TEST_F(MissionControlComponentTest, RepeatsAGoalWithoutAnswer) {
  const auto goal = first_goal();
  run(3);
  const auto again = goals_.take().at(0);
  EXPECT_EQ(again.id(), goal.id());
  EXPECT_EQ(again.mission(), goal.mission());
}

TEST_F(MissionControlComponentTest, PausesAndResumesWhenPeopleSaySo) {
  const auto goal = first_goal();
  say("pause");
  run(0.3);
  EXPECT_EQ(state(), "paused");
  const auto hold = goals_.take().at(0);
  EXPECT_EQ(hold.x(), 0);
  EXPECT_GT(hold.id(), goal.id());
  say("resume");
  run(0.3);
  EXPECT_EQ(state(), "running");
  EXPECT_EQ(goals_.take().at(0).x(), goal.x());
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

TEST_F(MissionControlComponentTest, RunsOnAfterTheMissionByDefault) {
  (void)first_goal();
  locate(1);
  run(0.3);
  locate(3);
  run(0.3);
  EXPECT_EQ(state(), "done");
  EXPECT_FALSE(exit_code_);
}

TEST_F(MissionControlComponentTest, RefusesAWaypointInAWall) {
  params_.map_file = write_map(true);
  EXPECT_THAT(error_of_start(), HasSubstr("waypoint 1 at (1, 0.5) is inside a wall"));
  params_.map_file = write_map(false);
  EXPECT_EQ(error_of_start(), "no error");
}

TEST_F(MissionControlComponentTest, RefusesToStartWithoutAMission) {
  params_.mission_file = "";
  EXPECT_EQ(error_of_start(), "mission_control.mission_file: is required");
  params_.mission_file = "/nowhere/m.yaml";
  EXPECT_THAT(error_of_start(), HasSubstr("/nowhere/m.yaml"));
}

TEST_F(MissionControlComponentTest, ParametersPrintAsYaml) {
  EXPECT_THAT(default_yaml<MissionControlComponent::Params>(), HasSubstr("goal_lifetime_s: 60"));
}

}  // namespace
}  // namespace tocsin
