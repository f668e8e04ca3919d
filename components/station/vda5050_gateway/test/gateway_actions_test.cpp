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

class GatewayActionsTest : public ::testing::Test, protected GatewayFixture {
 protected:
  void drive() {
    order(texts.order(3, 3));
    take();
    vehicle.mission = "running";
  }
  [[nodiscard]] std::vector<Kind> kinds() {
    std::vector<Kind> all;
    for (const Request& request : take()) all.push_back(request.kind);
    return all;
  }
  /// Charging at node b, on the way to c.
  void order_charging() {
    json text = texts.order(3, 3);
    text["nodes"][1]["actions"].push_back(OrderTexts::action("startCharging", "c1"));
    order(text);
    take();
    vehicle.mission = "running";
    news(News::succeeded);
    vehicle.mission = "done";
  }
};

TEST_F(GatewayActionsTest, CancelOrderEndsWhenTheVehicleStands) {
  drive();
  const std::string id = instant("cancelOrder", {{"orderId", "o1"}});
  EXPECT_THAT(kinds(), ElementsAre(Kind::cancel_drive));
  EXPECT_EQ(status(id), ActionStatus::running);
  EXPECT_FALSE(sut.order().is_idle());
  news(News::canceled);
  EXPECT_EQ(status(id), ActionStatus::finished);
  EXPECT_TRUE(sut.order().is_idle());
  EXPECT_THAT(errors(), IsEmpty());
  vehicle.mission = "aborted";
  wait(5);
  EXPECT_THAT(take(), IsEmpty());
  EXPECT_THAT(errors(), IsEmpty());
}

TEST_F(GatewayActionsTest, WhatCannotBeCanceledFails) {
  EXPECT_EQ(status(instant("cancelOrder")), ActionStatus::failed);
  EXPECT_THAT(errors(), ElementsAre(ErrorType::no_order_to_cancel));
  drive();
  EXPECT_THAT(errors(), IsEmpty()) << "an order was taken";
  EXPECT_EQ(status(instant("cancelOrder", {{"orderId", "o7"}})), ActionStatus::failed);
  EXPECT_FALSE(sut.order().is_idle());
  instant("cancelOrder");
  EXPECT_EQ(status(instant("cancelOrder")), ActionStatus::failed) << "it is being canceled";
}

TEST_F(GatewayActionsTest, AnOrderThatIsBeingCanceledTakesNoUpdate) {
  drive();
  instant("cancelOrder");
  json next = texts.order(2, 2, 2);
  next["orderUpdateId"] = 1;
  order(next);
  EXPECT_EQ(sut.order().update(), 0u);
  EXPECT_THAT(errors(), ElementsAre(ErrorType::other_order_active));
}

TEST_F(GatewayActionsTest, PausesUntilTheMissionIsPausedAndGoesOn) {
  drive();
  const std::string pause = instant("startPause");
  EXPECT_THAT(kinds(), ElementsAre(Kind::pause));
  EXPECT_EQ(status(pause), ActionStatus::running);
  wait(1.2);
  EXPECT_THAT(kinds(), ElementsAre(Kind::pause)) << "again, for it was not obeyed";
  vehicle.mission = "paused";
  step();
  EXPECT_EQ(status(pause), ActionStatus::finished);
  EXPECT_TRUE(sut.is_paused(vehicle));
  const std::string resume = instant("stopPause");
  EXPECT_THAT(kinds(), ElementsAre(Kind::resume));
  EXPECT_EQ(status(resume), ActionStatus::running);
  vehicle.mission = "running";
  step();
  EXPECT_EQ(status(resume), ActionStatus::finished);
  EXPECT_FALSE(sut.is_paused(vehicle));
}

TEST_F(GatewayActionsTest, InAPauseAnUpdateIsTakenAndDrivenLater) {
  drive();
  instant("startPause");
  vehicle.mission = "paused";
  step();
  take();
  json next = texts.order(2, 2, 2);
  next["orderUpdateId"] = 1;
  order(next);
  EXPECT_EQ(sut.order().update(), 1u);
  EXPECT_THAT(kinds(), IsEmpty());
  instant("stopPause");
  take();
  vehicle.mission = "running";
  step();
  EXPECT_THAT(take_drive(), ElementsAre(1, 2, 3));
}

TEST_F(GatewayActionsTest, AnOrderInAPauseIsDrivenAfterIt) {
  EXPECT_EQ(status(instant("startPause")), ActionStatus::finished);
  order(texts.order(2, 2));
  EXPECT_THAT(kinds(), IsEmpty());
  instant("stopPause");
  EXPECT_THAT(take_drive(), ElementsAre(1));
}

TEST_F(GatewayActionsTest, APauseOfTheStationsPeopleIsToldAndCanBeEnded) {
  drive();
  vehicle.mission = "paused";
  step();
  EXPECT_TRUE(sut.is_paused(vehicle));
  instant("stopPause");
  EXPECT_THAT(kinds(), ElementsAre(Kind::resume));
}

TEST_F(GatewayActionsTest, PeopleAtTheStationMayEndAPause) {
  drive();
  instant("startPause");
  vehicle.mission = "paused";
  step();
  vehicle.mission = "running";
  step();
  EXPECT_FALSE(sut.is_paused(vehicle));
}

TEST_F(GatewayActionsTest, ChargingOnANodeComesBeforeTheWayOn) {
  order_charging();
  step();
  EXPECT_THAT(kinds(), ElementsAre(Kind::dock));
  EXPECT_EQ(status("c1"), ActionStatus::running);
  vehicle.docking_run = 1;
  vehicle.docking = "scan";
  wait(5);
  EXPECT_THAT(kinds(), IsEmpty());
  vehicle.docking = "done";
  vehicle.docking_result = "docked";
  step();
  EXPECT_EQ(status("c1"), ActionStatus::finished);
  step();
  EXPECT_THAT(take_drive(), ElementsAre(2));
}

TEST_F(GatewayActionsTest, DockingIsAskedForAgainUntilItBegins) {
  order_charging();
  take();
  wait(3.2);
  EXPECT_THAT(kinds(), ElementsAre(Kind::dock));
  wait(180);
  EXPECT_EQ(status("c1"), ActionStatus::failed);
}

TEST_F(GatewayActionsTest, DockingThatFindsNoDockFails) {
  order_charging();
  vehicle.docking_run = 1;
  vehicle.docking = "done";
  vehicle.docking_result = "no_dock_found";
  step();
  EXPECT_EQ(status("c1"), ActionStatus::failed);
}

TEST_F(GatewayActionsTest, CancelEndsDocking) {
  order_charging();
  step();
  take();
  const std::string id = instant("cancelOrder");
  EXPECT_THAT(kinds(), ElementsAre(Kind::cancel_dock));
  EXPECT_EQ(status(id), ActionStatus::finished);
  EXPECT_EQ(status("c1"), ActionStatus::failed);
}

TEST_F(GatewayActionsTest, ChargesAtOnceWhereItStands) {
  const std::string id = instant("startCharging");
  EXPECT_THAT(kinds(), ElementsAre(Kind::dock));
  vehicle.docking_run = 1;
  vehicle.docking = "done";
  vehicle.docking_result = "docked";
  step();
  EXPECT_EQ(status(id), ActionStatus::finished);
  drive();
  EXPECT_EQ(status(instant("startCharging")), ActionStatus::failed) << "it drives";
}

TEST_F(GatewayActionsTest, WhereOthersLeadItNeitherDocksNorIsMoved) {
  vehicle.driver = "anna";
  const json place = {{"x", 3}, {"y", 1}, {"theta", 0.5}};
  EXPECT_EQ(status(instant("startCharging")), ActionStatus::failed);
  EXPECT_EQ(status(instant("initializePosition", place)), ActionStatus::failed);
  EXPECT_THAT(kinds(), IsEmpty());
  vehicle.driver = "";
  vehicle.pose.reset();
  EXPECT_EQ(status(instant("startCharging")), ActionStatus::failed);
  instant("initializePosition", place);
  EXPECT_THAT(kinds(), ElementsAre(Kind::set_pose)) << "that is what it waits for";
}

TEST_F(GatewayActionsTest, ThePositionIsSetWhenTheVehicleHasIt) {
  const json place = {{"x", 3}, {"y", 1}, {"theta", 0.5}, {"mapId", "map"}, {"lastNodeId", "n"}};
  const std::string id = instant("initializePosition", place);
  const auto asked = take();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].kind, Kind::set_pose);
  EXPECT_EQ(asked[0].poses.at(0).x_m, 3);
  EXPECT_EQ(status(id), ActionStatus::running);
  vehicle.pose = geometry::Pose{3.1, 1, 0.5};
  step();
  EXPECT_EQ(status(id), ActionStatus::finished);
  EXPECT_EQ(sut.order().last_node(), "n");
}

TEST_F(GatewayActionsTest, APositionThatCannotBeSetFails) {
  EXPECT_EQ(status(instant("initializePosition", {{"x", 3}})), ActionStatus::failed);
  EXPECT_THAT(errors(), ElementsAre(ErrorType::invalid_instant_action));
  const json elsewhere = {{"x", 3}, {"y", 1}, {"theta", 0}, {"mapId", "hall"}};
  EXPECT_EQ(status(instant("initializePosition", elsewhere)), ActionStatus::failed);
  const std::string id = instant("initializePosition", {{"x", 3}, {"y", 1}, {"theta", 0}});
  wait(11);
  EXPECT_EQ(status(id), ActionStatus::failed) << "the vehicle did not take it";
}

TEST_F(GatewayActionsTest, RequestsAreServedOnceAndUnknownActionsFail) {
  static_cast<void>(sut.take_state_request());
  EXPECT_EQ(status(instant("factsheetRequest")), ActionStatus::finished);
  EXPECT_TRUE(sut.take_factsheet_request());
  EXPECT_FALSE(sut.take_factsheet_request());
  instant("stateRequest");
  EXPECT_TRUE(sut.take_state_request());
  EXPECT_EQ(status(instant("dance")), ActionStatus::failed);
  EXPECT_THAT(errors(), ElementsAre(ErrorType::invalid_instant_action));
  instant("stateRequest");
  EXPECT_THAT(errors(), IsEmpty()) << "until another one is taken";
}

TEST_F(GatewayActionsTest, AnActionThatIsSentAgainIsDoneOnce) {
  sut.on_instant_actions(texts.instant("startCharging", "x"), vehicle, now);
  sut.on_instant_actions(texts.instant("startCharging", "x"), vehicle, now);
  step();
  EXPECT_THAT(kinds(), ElementsAre(Kind::dock));
  EXPECT_EQ(sut.instant_actions().size(), 1u);
}

TEST_F(GatewayActionsTest, StatesStayUntilTheyAreCleared) {
  for (std::size_t i = 0; i < Gateway::most_instant_actions; ++i) instant("stateRequest");
  instant("stateRequest");
  EXPECT_THAT(errors(), ElementsAre(ErrorType::instant_action_states_full));
  EXPECT_EQ(sut.instant_actions().size(), Gateway::most_instant_actions);
  instant("clearInstantActions");
  EXPECT_EQ(sut.instant_actions().size(), 1u);
  EXPECT_THAT(errors(), IsEmpty());
}

TEST(OldInstantActionsTest, MakeRoomByThemselves) {
  GatewayFixture old(Version::v2_1);
  for (int i = 0; i < 150; ++i) old.instant("stateRequest");
  EXPECT_LE(old.sut.instant_actions().size(), Gateway::most_instant_actions);
  EXPECT_THAT(old.errors(), IsEmpty());
  EXPECT_EQ(old.status(old.instant("clearInstantActions")), ActionStatus::failed) << "2.1 has none";
  EXPECT_EQ(old.status(old.instant("initPosition", {{"x", 0}, {"y", 0}, {"theta", 0}})),
            ActionStatus::finished);
}

}  // namespace
}  // namespace tocsin::vda5050
