// SPDX-License-Identifier: Apache-2.0
// The action follow_waypoints of the mission control, by a client of its host.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mission_control_component_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using Follow = action::FollowWaypoints;
using What = ActionClient<Follow>::What;

class Asker : public Component {
 public:
  explicit Asker(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (auto one = client.take(now)) news.push_back(*one);
  }
  ActionClient<Follow> client{*this};
  std::vector<ActionClient<Follow>::News> news;
};

class WaypointsServerTest : public MissionControlComponentTest {
 protected:
  WaypointsServerTest() {
    params_.mission_file = "";
    bus_.add(asker_);
  }
  void begin() {
    start();
    run(0.2);
    locate(0);
    run(0.2);
  }
  static Follow::Goal goal(const std::vector<double>& xs, const char* frame = "map") {
    Follow::Goal made;
    for (const double x : xs) {
      geometry_msgs::msg::PoseStamped pose;
      pose.header().frame_id(frame);
      pose.pose().position().x(x);
      pose.pose().position().y(0.5);
      pose.pose().orientation().w(1);
      made.poses().push_back(pose);
    }
    return made;
  }
  GoalId send(const Follow::Goal& goal) {
    const GoalId id = asker_.client.send(goal, bus_.now() + seconds(1), bus_.now() + seconds(1000));
    run(0.5);
    return id;
  }
  /// All but feedback.
  std::vector<What> steps(const GoalId& id) {
    std::vector<What> all;
    for (const auto& one : asker_.news) {
      if (one.id == id && one.what != What::feedback) all.push_back(one.what);
    }
    return all;
  }
  /// Indices that were told, without repetitions.
  std::vector<std::uint32_t> told(const GoalId& id) {
    std::vector<std::uint32_t> all;
    for (const auto& one : asker_.news) {
      if (one.id != id || one.what != What::feedback) continue;
      const std::uint32_t index = one.feedback->current_waypoint();
      if (all.empty() || all.back() != index) all.push_back(index);
    }
    return all;
  }
  const ActionClient<Follow>::News& end(const GoalId& id) {
    for (const auto& one : asker_.news) {
      if (one.id == id && one.what == What::result) return one;
    }
    ADD_FAILURE() << "it has not ended";
    return asker_.news.front();
  }
  Context asker_context_{bus_, "asker", Role::gcs};
  Asker asker_{asker_context_};
};

TEST_F(WaypointsServerTest, LeadsThroughThePosesAndTellsWhichOneIsDrivenTo) {
  begin();
  const GoalId id = send(goal({1, 3}));
  EXPECT_EQ(goals_.take().at(0).x(), 1);
  locate(1);
  run(0.3);
  EXPECT_EQ(goals_.take().at(0).x(), 3);
  locate(3);
  run(0.3);
  EXPECT_THAT(steps(id), ElementsAre(What::accepted, What::result));
  EXPECT_THAT(told(id), ElementsAre(0, 1));
  EXPECT_EQ(end(id).state, GoalState::succeeded);
  EXPECT_TRUE(end(id).result->missed_waypoints().empty());
  EXPECT_EQ(end(id).result->error_code(), 0);
  const auto status = statuses_.take().back();
  EXPECT_EQ(status.mission(), "follow_waypoints");
  EXPECT_EQ(status.state(), "done");
}

TEST_F(WaypointsServerTest, CanceledInTheMiddleItEndsWhenTheVehicleSaysThatItHalts) {
  begin();
  const GoalId id = send(goal({1, 3}));
  const auto first = goals_.take().at(0);
  tell(first, "driving");
  locate(0.4);
  asker_.client.cancel(id, bus_.now() + seconds(1));
  run(0.5);
  EXPECT_THAT(steps(id), ElementsAre(What::accepted, What::canceling));
  const auto halt = goals_.take().at(0);
  EXPECT_EQ(halt.x(), 0.4);
  EXPECT_EQ(halt.mission(), first.mission());
  EXPECT_GT(halt.id(), first.id());
  tell(halt, "reached");
  run(0.5);
  EXPECT_EQ(end(id).state, GoalState::canceled);
  EXPECT_EQ(end(id).result->error_msg(), "canceled");
  EXPECT_EQ(state(), "aborted");
}

TEST_F(WaypointsServerTest, ABlockedPoseIsToldAsMissed) {
  params_.control.blocked_limit_s = 1;
  begin();
  const GoalId id = send(goal({1, 3}));
  tell(goals_.take().at(0), "blocked");
  run(2);
  EXPECT_EQ(end(id).state, GoalState::aborted);
  const auto& result = *end(id).result;
  EXPECT_NE(result.error_code(), 0);
  EXPECT_EQ(result.error_msg(), "waypoint 1 is blocked");
  ASSERT_EQ(result.missed_waypoints().size(), 1U);
  EXPECT_EQ(result.missed_waypoints()[0].index(), 0U);
  EXPECT_EQ(result.missed_waypoints()[0].goal().pose().position().x(), 1);
  EXPECT_NE(result.missed_waypoints()[0].error_code(), 0);
}

TEST_F(WaypointsServerTest, ASecondGoalTakesOverAndTheFirstIsAborted) {
  begin();
  const GoalId first = send(goal({1}));
  const GoalId second = send(goal({3}));
  EXPECT_EQ(end(first).state, GoalState::aborted);
  EXPECT_EQ(end(first).result->error_msg(), "superseded by another goal");
  EXPECT_EQ(goals_.take().back().x(), 3);
  locate(3);
  run(0.3);
  EXPECT_EQ(end(second).state, GoalState::succeeded);
}

TEST_F(WaypointsServerTest, ARefusedGoalLeavesTheOneThatIsUnderWay) {
  begin();
  const GoalId first = send(goal({1}));
  const GoalId second = send(goal({3}, "odom"));
  EXPECT_THAT(steps(second), ElementsAre(What::rejected));
  const auto rejected = std::find_if(asker_.news.begin(), asker_.news.end(),
                                     [&](const auto& one) { return one.id == second; });
  ASSERT_TRUE(rejected->result);
  EXPECT_THAT(rejected->result->error_msg(), ::testing::HasSubstr("frame"));
  locate(1);
  run(0.3);
  EXPECT_EQ(end(first).state, GoalState::succeeded);
}

TEST_F(WaypointsServerTest, TakesThePlaceOfTheMissionOfTheFile) {
  params_.mission_file = folder_ / "two.yaml";
  begin();
  run(2);
  const auto from_file = goals_.take().at(0);
  const GoalId id = send(goal({2}));
  const auto asked = goals_.take().at(0);
  EXPECT_EQ(asked.x(), 2);
  EXPECT_NE(asked.mission(), from_file.mission());
  locate(2);
  run(0.3);
  EXPECT_EQ(end(id).state, GoalState::succeeded);
  EXPECT_EQ(state(), "done");
}

TEST_F(WaypointsServerTest, AGoalInPlaceOfTheMissionOfTheFileDoesNotEndTheProcess) {
  params_.mission_file = folder_ / "two.yaml";
  params_.exit_when_over = true;
  begin();
  run(2);
  send(goal({2}));
  locate(2);
  run(0.3);
  EXPECT_EQ(state(), "done");
  EXPECT_FALSE(exit_code_);
}

TEST_F(WaypointsServerTest, EndsTheProcessWithTheGoalWhenToldSo) {
  params_.exit_when_over = true;
  begin();
  const GoalId id = send(goal({1}));
  EXPECT_FALSE(exit_code_);
  locate(1);
  run(0.3);
  EXPECT_EQ(end(id).state, GoalState::succeeded);
  EXPECT_EQ(exit_code_, 0);
}

}  // namespace
}  // namespace tocsin
