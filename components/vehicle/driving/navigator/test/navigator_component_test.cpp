// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>

#include "foundation/error.hpp"
#include "navigator_rig.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

TEST_F(NavigatorComponentTest, DrivesToAGoal) {
  run(0.2);
  send_goal(5, 2);
  run(1);
  EXPECT_EQ(status_.state(), "driving");
  EXPECT_NEAR(status_.distance_m(), 3, 0.2);
  run(12);
  EXPECT_EQ(status_.state(), "reached");
  EXPECT_EQ(status_.goal_id(), 5U);
  EXPECT_NEAR(odom_.x_m, 3, 0.2);
}

TEST_F(NavigatorComponentTest, TellsItsPlanOnceToWhoReads) {
  SimReader<topic::Plan> plans(bus_);
  run(0.2);
  send_goal(5, 2);
  run(2);
  const auto all = plans.take();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].header().frame_id(), "map");
  ASSERT_GE(all[0].poses().size(), 2U);
  EXPECT_NEAR(all[0].poses().front().pose().position().x(), -1, 0.1);
  EXPECT_NEAR(all[0].poses().back().pose().position().x(), 2, 0.1);
}

TEST_F(NavigatorComponentTest, CommandsAtItsRateHoweverOftenAPoseComes) {
  bus_.add(*sut_);
  send_goal(5, 2);
  for (int i = 0; i < 100; ++i) {  // two seconds
    bus_.publish<topic::Odom>(odometry());
    bus_.run_for(seconds(0.02));
  }
  EXPECT_NEAR(static_cast<double>(commands_.take().size()), 40, 2);
}

TEST_F(NavigatorComponentTest, AnswersAnEmergencyStopBetweenTwoCommands) {
  bus_.add(*sut_);
  send_goal(5, 2);
  for (int i = 0; i < 30; ++i) {
    bus_.publish<topic::Odom>(odometry());
    bus_.run_for(seconds(0.02));
  }
  bus_.run_for(seconds(0.001));
  ASSERT_GT(commands_.take().back().linear().x(), 0);
  press_emergency_stop(true);
  bus_.run_for(Duration{0});
  const auto commands = commands_.take();
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].linear().x(), 0);
}

TEST_F(NavigatorComponentTest, TheFalseOfAnotherDoesNotReleaseTheEmergencyStop) {
  SimWriter<topic::EmergencyStop> station(bus_, topic::EmergencyStop::station);
  topic::EmergencyStop::Message word;
  word.data(true);
  ASSERT_EQ(station.write(word), Status::ok);
  send_goal(5, 2);
  press_emergency_stop(false);
  run(1);
  EXPECT_EQ(status_.state(), "held");
  word.data(false);
  ASSERT_EQ(station.write(word), Status::ok);
  run(1);
  EXPECT_EQ(status_.state(), "driving");
}

TEST_F(NavigatorComponentTest, CommandsTheBaseToStandOnceAndIsSilentThen) {
  sut_->tick(bus_.now());
  const auto commands = commands_.take();
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0].linear().x(), 0);
  EXPECT_TRUE(locations_.take().empty()) << "before odometry";
  run(1);
  commands_.take();
  sut_->tick(bus_.now());
  EXPECT_TRUE(commands_.take().empty());
}

TEST_F(NavigatorComponentTest, ReportsItsLocationOnTheMapFiveTimesASecond) {
  odom_ = {0.5, 0, 0};
  run(2);
  const auto locations = locations_.take();
  EXPECT_NEAR(static_cast<double>(locations.size()), 10, 1);
  EXPECT_EQ(locations.back().header().frame_id(), "map");
  EXPECT_NEAR(locations.back().pose().pose().position().x(), -0.5, 1e-9);
}

TEST_F(NavigatorComponentTest, ReportsAChangeAtOnceAndElseOnceASecond) {
  run(0.5);
  statuses_.take();
  send_goal(5, 2);
  sut_->tick(bus_.now());
  const auto statuses = statuses_.take();
  ASSERT_EQ(statuses.size(), 1U);
  EXPECT_EQ(statuses[0].goal_id(), 5U);
  for (int i = 0; i < 15; ++i) {
    bus_.publish<topic::Odom>(odometry());
    bus_.run_for(seconds(0.06));
    sut_->tick(bus_.now());
  }
  EXPECT_TRUE(statuses_.take().empty());
  bus_.run_for(seconds(0.11));
  sut_->tick(bus_.now());
  EXPECT_EQ(statuses_.take().size(), 1U);
}

TEST_F(NavigatorComponentTest, StandsWhileTheLinkSaysSoAndWhenItsRouterFallsSilent) {
  run(0.2);
  send_goal(5, 4);
  run(2);
  hear_link(true);
  run(0.05);
  EXPECT_EQ(command_.linear().x(), 0);
  hear_link(false);
  run(0.9);
  EXPECT_GT(command_.linear().x(), 0.2);
  run(0.2);
  EXPECT_EQ(command_.linear().x(), 0);
  EXPECT_EQ(status_.state(), "held");
}

TEST_F(NavigatorComponentTest, AGoalLivesFromItsArrivalWhateverTheClocksSay) {
  for (const double age_s : {86400.0, -86400.0}) {
    start();
    run(0.2);
    send_goal(5, 4.5, age_s, 2);
    run(1.5);
    EXPECT_EQ(status_.state(), "driving") << age_s;
    run(1);
    EXPECT_EQ(status_.state(), "held") << age_s;
  }
}

TEST_F(NavigatorComponentTest, StandsAtAGoalForWhatItsOwnRouterHasStored) {
  const auto tell_store = [this](const char* role, std::uint32_t waiting) {
    topic::LinkState::Message state;
    state.role(role);
    state.stored().resize(2);
    state.stored()[1].waiting(waiting);
    bus_.publish<topic::LinkState>(state);
  };
  run(0.2);
  goal_.send_s(20);
  send_goal(5, 0);
  for (int i = 0; i < 6; ++i) {
    tell_store("uxv", 50);
    tell_store("gcs", 0);
    run(1);
  }
  EXPECT_EQ(status_.state(), "held");
  EXPECT_EQ(status_.reason(), "sending");
  EXPECT_NEAR(odom_.x_m, 1, 0.2);
  tell_store("uxv", 0);
  run(1);
  EXPECT_EQ(status_.state(), "reached");
  EXPECT_EQ(status_.reason(), "");
}

TEST_F(NavigatorComponentTest, TakesTheWaypointsAheadOutOfAGoal) {
  run(0.2);
  goal_.ahead().resize(1);
  goal_.ahead()[0].x(1);
  send_goal(5, -0.9);
  run(8);
  EXPECT_EQ(status_.goal_id(), 6U);
  EXPECT_EQ(status_.state(), "reached");
  EXPECT_NEAR(odom_.x_m, 2, 0.2);
}

TEST_F(NavigatorComponentTest, RefusesAGoalWithNan) {
  run(0.2);
  send_goal(5, std::numeric_limits<double>::quiet_NaN());
  send_goal(6, 2, 0, std::numeric_limits<double>::quiet_NaN());
  run(1);
  EXPECT_EQ(status_.state(), "idle");
}

TEST_F(NavigatorComponentTest, HearsOnlyTheGroundStationsHeartbeat) {
  params_.navigator.on_link_lost = OnLinkLost::hold;
  params_.navigator.link_lost_after_s = 1;
  start();
  run(0.2);
  send_goal(5, 4.5);
  for (int i = 0; i < 4; ++i) {
    run(0.5);
    send_heartbeat("gcs");
  }
  run(0.5);
  EXPECT_EQ(status_.state(), "driving");
  for (int i = 0; i < 4; ++i) {
    run(0.5);
    send_heartbeat("uxv");
  }
  EXPECT_EQ(status_.state(), "held");
}

TEST_F(NavigatorComponentTest, KnowsWhereItIsAfterARestart) {
  context_.run_dir = folder_.string();
  start();
  odom_ = {2, 0, 0};
  run(2);
  odom_ = {0, 0, 0};  // the driver died as well
  start();
  run(0.2);
  EXPECT_NEAR(locations_.take().back().pose().pose().position().x(), 1, 1e-9);
}

TEST_F(NavigatorComponentTest, GoesOnWithItsGoalAfterARestartUntilTheLeaseIsOver) {
  context_.run_dir = folder_.string();
  start();
  run(0.2);
  send_goal(5, 3, 0, 12);
  run(2);
  start();
  run(1);
  EXPECT_EQ(status_.state(), "driving");
  EXPECT_EQ(status_.goal_id(), 5U);
  run(10);
  EXPECT_EQ(status_.state(), "reached");
  start();
  run(1);
  EXPECT_EQ(status_.state(), "idle") << "the lease is over";
}

TEST_F(NavigatorComponentTest, DrivesOnAMapThatGrows) {
  params_.map_file = "";
  start();
  send_goal(5, 2);
  run(2);
  EXPECT_EQ(status_.state(), "blocked") << "nothing is known";
  topic::Map::Message map;
  map.info().resolution(0.1F);
  map.info().width(60);
  map.info().height(20);
  map.info().origin().position().x(-3);
  map.info().origin().position().y(-1);
  map.info().origin().orientation().w(1);
  map.data(std::vector<std::int8_t>(1200, 0));
  bus_.publish<topic::Map>(map);
  run(10);
  EXPECT_EQ(status_.state(), "reached");

  // A wall across the way to the next goal.
  topic::MapUpdates::Message wall;
  wall.x(20);
  wall.width(1);
  wall.height(20);
  wall.data(std::vector<std::int8_t>(20, 100));
  bus_.publish<topic::MapUpdates>(wall);
  send_goal(6, -2);
  run(5);
  EXPECT_EQ(status_.state(), "blocked");
}

/// A hall of 12 m x 6 m, and a link that is lost in its middle, in the lower half.
void publish_hall(SimBus& bus) {
  topic::Map::Message map;
  map.info().resolution(0.1F);
  map.info().width(120);
  map.info().height(60);
  map.info().origin().position().x(-3);
  map.info().origin().position().y(-1);
  map.info().origin().orientation().w(1);
  map.data(std::vector<std::int8_t>(7200, 0));
  bus.publish<topic::Map>(map);
}
topic::LinkRisk::Message dead_middle() {
  topic::LinkRisk::Message risk;
  risk.info().resolution(1);
  risk.info().width(12);
  risk.info().height(6);
  risk.info().origin().position().x(-3);
  risk.info().origin().position().y(-1);
  risk.info().origin().orientation().w(1);
  risk.data(std::vector<std::int8_t>(72, 1));
  for (const std::size_t cell : {5U, 6U, 17U, 18U}) risk.data()[cell] = 95;
  return risk;
}

TEST_F(NavigatorComponentTest, TakesAWayThatKeepsTheLinkAndTellsWhatItCosts) {
  params_.map_file = "";
  params_.navigator.surroundings.link_detour = 0.5;
  SimReader<topic::PlanChoice> choices(bus_);
  start();
  publish_hall(bus_);
  bus_.publish<topic::LinkRisk>(dead_middle());
  send_goal(5, 7);
  run(2);
  const auto all = choices.take();
  ASSERT_FALSE(all.empty());
  const auto& choice = all.back();
  EXPECT_NEAR(choice.shortest_m(), 8, 0.3);
  EXPECT_GT(choice.shortest_silence_s(), 3);
  EXPECT_LT(choice.silence_s(), 1);
  EXPECT_GT(choice.way_m(), choice.shortest_m());
  ASSERT_GE(choice.shortest().size(), 2U);
  EXPECT_NEAR(choice.shortest().back().x(), 7, 0.1);
}

TEST_F(NavigatorComponentTest, IgnoresAMapOfTheLinkThatIsNone) {
  params_.map_file = "";
  params_.navigator.surroundings.link_detour = 0.5;
  SimReader<topic::PlanChoice> choices(bus_);
  start();
  publish_hall(bus_);
  auto risk = dead_middle();
  risk.data().pop_back();
  bus_.publish<topic::LinkRisk>(risk);
  risk = dead_middle();
  risk.info().origin().orientation().z(1);
  bus_.publish<topic::LinkRisk>(risk);
  risk = dead_middle();
  risk.info().resolution(std::numeric_limits<float>::quiet_NaN());
  bus_.publish<topic::LinkRisk>(risk);
  send_goal(5, 7);
  run(2);
  EXPECT_EQ(status_.state(), "driving");
  EXPECT_TRUE(choices.take().empty());
}

TEST_F(NavigatorComponentTest, RefusesToStartWithoutTheMapThatItIsToldOf) {
  params_.map_file = "/nowhere/m.yaml";
  EXPECT_THROW(start(), ConfigError);
}

TEST_F(NavigatorComponentTest, DrivesAtTheSpeedThatIsSetWhileItDrivesAndKeepsItOnARefusal) {
  const ComponentEntry entry = make_component_entry<NavigatorComponent>();
  send_goal(5, 4);
  run(3);
  EXPECT_NEAR(command_.linear().x(), 0.5, 0.01);
  const std::string map = "map_file: " + params_.map_file;
  entry.change(*sut_, YAML::Load(map + "\nspeed_mps: 0.2"), {});
  sut_->take_changes();
  run(2);
  EXPECT_NEAR(command_.linear().x(), 0.2, 0.01);
  EXPECT_THROW(entry.change(*sut_, YAML::Load(map + "\nspeed_mps: 0.8"), {}), ConfigError);
  sut_->take_changes();
  run(1);
  EXPECT_NEAR(command_.linear().x(), 0.2, 0.01);
}

}  // namespace
}  // namespace tocsin
