// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mission_control_fixture.hpp"

namespace tocsin {
namespace {

using Kind = MissionOrder::Kind;
using State = MissionControl::State;

TEST(MissionOrders, AreReadFromTheirWordsOnly) {
  EXPECT_EQ(mission_order_of("pause")->kind, Kind::pause);
  EXPECT_EQ(mission_order_of("resume")->kind, Kind::resume);
  EXPECT_EQ(mission_order_of("skip 1")->waypoint, 0U);
  EXPECT_EQ(mission_order_of("skip 4294967295")->waypoint, 4294967294U);
  for (const char* words : {"", "Pause", "pause ", "skip", "skip ", "skip 0", "skip -1", "skip +1",
                            "skip 1 ", "skip 4294967296", "skip one"}) {
    EXPECT_FALSE(mission_order_of(words)) << words;
  }
}

class PauseTest : public MissionControlTest {
 protected:
  void obey(Kind kind, std::uint32_t waypoint = 0) { sut.obey({kind, waypoint}, now_); }
  /// Drives to the first waypoint and is paused at 3 s, where x is -2.
  MissionControl::Goal paused() {
    first_ = first_goal();
    now_ = t0 + seconds(3);
    hear(first_.name, "driving");
    hear(-2);
    obey(Kind::pause);
    return at(3).value();
  }
  MissionControl::Goal first_;
};

TEST_F(PauseTest, HoldsTheVehicleWhereItWasLastSeen) {
  const auto hold = paused();
  EXPECT_EQ(progress().state, State::paused);
  EXPECT_EQ(hold.pose.x_m, -2);
  EXPECT_EQ(hold.name.mission, first_.name.mission);
  EXPECT_GT(hold.name.id, first_.name.id) << "the vehicle obeys the greater id of a mission";
  EXPECT_TRUE(hold.ahead.empty());
}

TEST_F(PauseTest, RepeatsTheHoldUntilTheVehicleNamesItAndThenLeavesItToOthers) {
  const auto hold = paused();
  EXPECT_FALSE(at(5.9));
  EXPECT_EQ(at(6).value().name.id, hold.name.id);
  hear(hold.name, "reached");
  EXPECT_FALSE(at(9));
  hear({77, 1}, "driving");  // a goal of the operator
  EXPECT_FALSE(at(500));
  EXPECT_EQ(progress().state, State::paused);
}

TEST_F(PauseTest, GoesOnWithTheSameWaypointAsAMissionThatTheVehicleHasNotSeen) {
  const auto hold = paused();
  hear(hold.name, "reached");
  (void)at(10);
  obey(Kind::resume);
  const auto goal = at(10).value();
  EXPECT_EQ(progress().state, State::running);
  EXPECT_EQ(goal.waypoint, 0U);
  EXPECT_EQ(goal.name.id, 1U);
  EXPECT_NE(goal.name.mission, hold.name.mission);
  hear(hold.name, "reached");  // late
  EXPECT_EQ(at(13).value().name.mission, goal.name.mission);
}

TEST_F(PauseTest, ItsTimeDoesNotCountForTheWaypointsLimit) {
  const auto hold = paused();
  hear(hold.name, "reached");
  (void)at(5000);
  obey(Kind::resume);
  (void)at(5000);
  EXPECT_EQ(progress().state, State::running);
  (void)at(5000 + 900);
  EXPECT_EQ(progress().state, State::aborted);
}

TEST_F(PauseTest, ArrivesNowhereWhileItIsPaused) {
  (void)paused();
  hear(1);
  (void)at(4);
  EXPECT_EQ(progress().waypoint, 0U);
  obey(Kind::resume);
  (void)at(5);
  EXPECT_EQ(progress().waypoint, 1U) << "the vehicle was driven there by hand";
}

TEST_F(PauseTest, OfAMissionThatHasNotBegunSendsNothing) {
  (void)at(0);
  obey(Kind::pause);
  hear(-5);
  EXPECT_FALSE(at(60));
  EXPECT_EQ(progress().state, State::paused);
  obey(Kind::resume);
  EXPECT_TRUE(at(60));
}

TEST_F(PauseTest, IsKnownToASuccessorByTheVehiclesStatusAlone) {
  const auto hold = paused();
  MissionControl anew({}, two_waypoints, 2);
  anew.on_status(hold.name, "reached", now_);
  EXPECT_FALSE(anew.update(now_));
  EXPECT_EQ(anew.progress(now_).state, State::paused);
  anew.obey({Kind::resume}, now_);
  EXPECT_EQ(anew.update(now_).value().waypoint, 0U);
}

TEST_F(PauseTest, IsNothingForAMissionThatIsOver) {
  (void)first_goal();
  hear(1);
  (void)at(3);
  hear(5);
  (void)at(4);
  obey(Kind::pause);
  EXPECT_EQ(progress().state, State::done);
}

class SkipTest : public PauseTest {};

TEST_F(SkipTest, LeavesOutThePresentWaypointOnce) {
  const auto first = first_goal();
  obey(Kind::skip, 0);
  const auto second = at(2.2).value();
  EXPECT_EQ(second.waypoint, 1U);
  EXPECT_EQ(second.name.mission, first.name.mission);
  EXPECT_EQ(second.name.id, first.name.id + 1);
  EXPECT_TRUE(sut.arrivals().empty());
}

TEST_F(SkipTest, IsNotForAnotherWaypointNorForTheLast) {
  (void)first_goal();
  obey(Kind::skip, 1);
  EXPECT_EQ(progress().waypoint, 0U);
  obey(Kind::skip, 0);
  obey(Kind::skip, 1);
  (void)at(2.2);
  EXPECT_EQ(progress().waypoint, 1U);
  EXPECT_EQ(progress().state, State::running);
}

TEST_F(SkipTest, IsNothingWhileItIsPaused) {
  (void)paused();
  obey(Kind::skip, 0);
  EXPECT_EQ(progress().waypoint, 0U);
}

}  // namespace
}  // namespace tocsin
