// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gateway_fixture.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = Request::Kind;
using News = DriveNews::Kind;

class GatewayTest : public ::testing::Test, protected GatewayFixture {
 protected:
  static json update(json order, int number) {
    order["orderUpdateId"] = number;
    return order;
  }
};

TEST_F(GatewayTest, DrivesTheBaseAndReportsNodeAfterNode) {
  order(texts.order(4, 3));
  EXPECT_THAT(take_drive(), ElementsAre(1, 2));
  vehicle.mission = "running";
  news(News::at, 1);
  EXPECT_EQ(sut.order().last_node(), "b");
  news(News::succeeded);
  EXPECT_EQ(sut.order().last_node(), "c");
  EXPECT_FALSE(sut.order().is_idle()) << "the horizon is left";
  wait(5);
  EXPECT_THAT(take(), IsEmpty());
  EXPECT_THAT(errors(), IsEmpty());
}

TEST_F(GatewayTest, AnUpdateMakesTheDriveLongerWhileItGoesOn) {
  order(texts.order(3, 2));
  EXPECT_THAT(take_drive(), ElementsAre(1));
  vehicle.mission = "running";
  order(update(texts.order(3, 3, 1), 1));
  EXPECT_THAT(take_drive(), ElementsAre(1, 2, 3));
}

TEST_F(GatewayTest, NearANodeTheDriveIsNotReplacedUntilItIsReached) {
  order(texts.order(3, 2));
  take();
  vehicle.mission = "running";
  vehicle.pose = geometry::Pose{0.8, 0, 0};
  order(update(texts.order(3, 3, 1), 1));
  EXPECT_THAT(take(), IsEmpty());
  news(News::succeeded);
  EXPECT_THAT(take_drive(), ElementsAre(2, 3));
}

TEST_F(GatewayTest, WhatIsRefusedChangesNothingAndIsToldUntilAnotherIsTaken) {
  order(texts.order(3, 3));
  take();
  vehicle.mission = "running";
  json wrong = update(texts.order(3, 3, 2), 1);
  wrong["nodes"][0]["released"] = "x";
  order(wrong);
  order(update(texts.order(3, 3, 1), 0));
  EXPECT_THAT(errors(),
              ElementsAre(ErrorType::validation_failure, ErrorType::same_order_update_id));
  EXPECT_EQ(sut.order().update(), 0u);
  EXPECT_THAT(take(), IsEmpty());
  order(update(texts.order(2, 2, 2), 1));
  EXPECT_THAT(errors(), IsEmpty());
  EXPECT_THAT(take_drive(), ElementsAre(1, 2, 3));
}

TEST_F(GatewayTest, ANodeInAWallIsRefusedWithItsName) {
  auto with_map = params(Version::v3_0);
  navigation::Grid grid{6, 2, 1, {-1, -1}};
  std::vector<navigation::Cell> cells(grid.size(), navigation::Cell::free);
  cells[4] = navigation::Cell::occupied;  // x from 3 to 4
  with_map.map = navigation::OccupancyMap(grid, cells);
  Gateway mapped(with_map);
  mapped.on_order(texts.order(5, 5).dump(), vehicle);
  ASSERT_EQ(mapped.faults(vehicle).size(), 1u);
  EXPECT_EQ(mapped.faults(vehicle)[0].type, ErrorType::no_route_to_target);
  EXPECT_THAT(mapped.faults(vehicle)[0].description, ::testing::HasSubstr("node 'd'"));
  EXPECT_EQ(mapped.order().id(), "");
  mapped.on_order(texts.order(3, 3).dump(), vehicle);
  EXPECT_EQ(mapped.order().id(), "o1");
  with_map.map = navigation::OccupancyMap(
      grid, {navigation::Cell::free, navigation::Cell::occupied, navigation::Cell::free,
             navigation::Cell::free, navigation::Cell::free, navigation::Cell::free,
             navigation::Cell::free, navigation::Cell::free, navigation::Cell::free,
             navigation::Cell::free, navigation::Cell::free, navigation::Cell::free});
  Gateway standing(with_map);
  standing.on_order(texts.order(1, 1).dump(), vehicle);
  EXPECT_EQ(standing.order().id(), "o1") << "it stands on the first node, whatever the map says";
}

TEST_F(GatewayTest, ADriveThatEndsOnTheWayMakesItsNodeUnreachable) {
  order(texts.order(3, 3));
  take();
  vehicle.mission = "running";
  news(News::at, 1);
  vehicle.mission = "aborted";
  news(News::aborted, 0, "blocked for 60 s");
  EXPECT_THAT(errors(), IsEmpty()) << "others may have taken its place";
  wait(2.1);
  ASSERT_THAT(errors(), ElementsAre(ErrorType::node_unreachable));
  EXPECT_THAT(sut.faults(vehicle)[0].description, ::testing::HasSubstr("'c': blocked for 60 s"));
  EXPECT_FALSE(sut.order().is_idle()) << "an error clears no order";
  EXPECT_THAT(take(), IsEmpty());
  const std::string cancel = instant("cancelOrder");
  EXPECT_EQ(status(cancel), ActionStatus::finished);
  EXPECT_TRUE(sut.order().is_idle());
  EXPECT_THAT(errors(), IsEmpty());
}

TEST_F(GatewayTest, WhoElseLeadsTheVehicleEndsTheOrderAndItsMode) {
  order(texts.order(3, 3));
  take();
  vehicle.mission = "running";
  news(News::aborted, 0, "superseded by another goal");
  wait(2.1);
  EXPECT_EQ(sut.mode(vehicle), Mode::manual);
  EXPECT_TRUE(sut.order().is_idle());
  EXPECT_THAT(errors(), IsEmpty());
  json other = texts.order(2, 2);
  other["orderId"] = "o2";
  order(other);
  EXPECT_THAT(errors(), ElementsAre(ErrorType::mobile_robot_not_available));
  vehicle.mission = "done";
  step();
  EXPECT_EQ(sut.mode(vehicle), Mode::automatic);
  order(other);
  EXPECT_THAT(take_drive(), ElementsAre(1));
}

TEST_F(GatewayTest, TheEndOfItsOwnDriveIsNobodyElses) {
  order(texts.order(2, 2));
  vehicle.mission = "running";
  news(News::succeeded);
  wait(1.5);  // "done" is on its way
  EXPECT_EQ(sut.mode(vehicle), Mode::automatic);
  vehicle.mission = "done";
  wait(3);
  EXPECT_EQ(sut.mode(vehicle), Mode::automatic);
}

TEST_F(GatewayTest, WhoDrivesByHandIntervenesAndTheOrderStays) {
  order(texts.order(2, 2));
  vehicle.driver = "anna";
  step();
  EXPECT_EQ(sut.mode(vehicle), Mode::intervened);
  EXPECT_FALSE(sut.order().is_idle());
}

TEST_F(GatewayTest, TakesNoOrderBeforePositionAndMissionWereHeard) {
  for (const bool is_placed : {false, true}) {
    vehicle.pose.reset();
    vehicle.mission = is_placed ? "" : "idle";
    if (is_placed) vehicle.pose = geometry::Pose{};
    order(texts.order(2, 2));
    EXPECT_EQ(sut.mode(vehicle), Mode::startup);
    EXPECT_THAT(errors(), ElementsAre(ErrorType::mobile_robot_not_available));
  }
  vehicle.mission = "idle";
  order(texts.order(2, 2));
  EXPECT_THAT(errors(), IsEmpty());
}

TEST_F(GatewayTest, ADriveThatNobodyKnowsAnyMoreIsAskedForAgain) {
  order(texts.order(3, 3));
  take();
  vehicle.mission = "running";
  news(News::at, 1);
  vehicle.mission = "idle";  // mission_control was started anew
  wait(4);
  EXPECT_THAT(take(), IsEmpty());
  wait(7);
  EXPECT_THAT(take_drive(), ElementsAre(2));
}

TEST_F(GatewayTest, WithoutMissionControlItAsksEveryFiveSeconds) {
  order(texts.order(2, 2));
  take();
  news(News::unanswered);
  wait(4);
  EXPECT_THAT(take(), IsEmpty());
  wait(2);
  EXPECT_THAT(take_drive(), ElementsAre(1));
}

TEST_F(GatewayTest, AsksForMoreBaseWhereThereIsAHorizon) {
  order(texts.order(6, 6));
  EXPECT_FALSE(sut.wants_base());
  order(update(texts.order(4, 1, 5), 1));
  EXPECT_FALSE(sut.wants_base()) << "4 m are left";
  news(News::at, 3);
  EXPECT_TRUE(sut.wants_base());
}

TEST_F(GatewayTest, TellsThatTheVehicleDoesNotKnowWhereItIs) {
  vehicle.navigation_reason = "no_pose";
  vehicle.hazard = true;
  EXPECT_THAT(errors(), ElementsAre(ErrorType::localization_error, ErrorType::hazard_detected));
}

TEST_F(GatewayTest, ErrorsDoNotPileUp) {
  for (int i = 0; i < 100; ++i) order({{"headerId", i}});
  EXPECT_THAT(errors(), ElementsAre(ErrorType::validation_failure));
}

/// A gateway that takes the place of one that was driving a, b, c and died.
class SuccessorTest : public GatewayTest {
 protected:
  SuccessorTest() {
    order(texts.order(4, 3));
    take();
    successor.resume(*OrderBook::restore(sut.order().save()));
    vehicle.way = {{1, 0}, {2, 0}};
    vehicle.mission = "running";
  }
  std::vector<Request> update() {
    now += seconds(0.1);
    return successor.update(vehicle, now);
  }
  Gateway successor{params(Version::v3_0)};
};

TEST_F(SuccessorTest, WaitsUntilItKnowsTheVehicle) {
  vehicle.mission = "";
  EXPECT_THAT(update(), IsEmpty());
  EXPECT_EQ(successor.mode(vehicle), Mode::startup);
  vehicle.mission = "running";
  EXPECT_EQ(update().size(), 1u);
  EXPECT_EQ(successor.mode(vehicle), Mode::automatic);
}

TEST_F(SuccessorTest, WaitsForTheWayOfAMissionThatIsUnderWay) {
  vehicle.mission = "";
  EXPECT_THAT(update(), IsEmpty());
  vehicle.mission = "running";
  vehicle.way.clear();
  EXPECT_THAT(update(), IsEmpty());
  EXPECT_EQ(successor.mode(vehicle), Mode::startup);
  vehicle.way = {{1, 0}, {2, 0}};
  EXPECT_EQ(update().size(), 1u);
}

TEST_F(SuccessorTest, AMissionWithoutAWayIsSomebodyElses) {
  vehicle.mission = "";
  EXPECT_THAT(update(), IsEmpty());
  vehicle.mission = "running";
  vehicle.way.clear();
  for (int i = 0; i < 25; ++i) EXPECT_THAT(update(), IsEmpty());
  EXPECT_EQ(successor.mode(vehicle), Mode::manual);
}

TEST_F(SuccessorTest, DrivesWhatIsLeftAndKnowsWhatWasReached) {
  vehicle.waypoint = 1;
  const auto requests = update();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].kind, Kind::drive);
  ASSERT_EQ(requests[0].poses.size(), 1u);
  EXPECT_EQ(requests[0].poses[0].x_m, 2);
  EXPECT_EQ(successor.order().last_node(), "b");
}

TEST_F(SuccessorTest, ALegThatEndedMeanwhileIsReached) {
  vehicle.mission = "done";
  EXPECT_THAT(update(), IsEmpty());
  EXPECT_EQ(successor.order().last_node(), "c");
  EXPECT_TRUE(successor.order().has_horizon());
}

TEST_F(SuccessorTest, WithoutAMissionItDrivesTheLegAnew) {
  vehicle.mission = "idle";
  vehicle.way.clear();
  EXPECT_EQ(update().at(0).poses.size(), 2u);
}

TEST_F(SuccessorTest, LeavesTheVehicleToOthersWhoLeadIt) {
  for (const char* mission : {"running", "paused"}) {
    Gateway other{params(Version::v3_0)};
    other.resume(*OrderBook::restore(sut.order().save()));
    vehicle.mission = mission;
    if (vehicle.mission == "running") vehicle.way = {{5, 5}};
    EXPECT_THAT(other.update(vehicle, now), IsEmpty()) << mission;
    EXPECT_EQ(other.mode(vehicle), Mode::manual);
    EXPECT_TRUE(other.order().is_idle());
    vehicle.way = {{1, 0}, {2, 0}};
  }
}

}  // namespace
}  // namespace tocsin::vda5050
