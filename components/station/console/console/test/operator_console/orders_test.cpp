// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "operator_console/dock_order.hpp"
#include "operator_console/emergency_stop_order.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using StopWish = EmergencyStopOrder::Wish;
using DockWish = DockOrder::Wish;

const Time t0 = Time{} + seconds(100);

class EmergencyStopOrderTest : public ::testing::Test {
 protected:
  using Asked = EmergencyStopOrder::Asked;
  static constexpr Duration wait = std::chrono::seconds(5);
  static constexpr Duration tick{1};
  const Time late_ = t0 + EmergencyStopOrder::direct_after;
  const Time deadline_ = t0 + wait;

  EmergencyStopOrder on_{StopWish::on, t0, wait};
  EmergencyStopOrder off_{StopWish::off, t0, wait};
  EmergencyStopOrder status_{StopWish::status, t0, wait};
};

TEST_F(EmergencyStopOrderTest, IsObeyedWhenTheStationHasTakenItAndTheVehicleStands) {
  EXPECT_EQ(on_.request(), true);
  on_.on_vehicle(false, {});
  on_.on_station(Asked::on);
  EXPECT_FALSE(on_.result(t0));
  on_.on_vehicle(true, {"station"});
  ASSERT_TRUE(on_.result(t0));
  EXPECT_EQ(on_.result(t0)->code, 0);
  EXPECT_EQ(on_.result(t0)->text, "emergency stop ON: the vehicle stands");
}

TEST_F(EmergencyStopOrderTest, AnOlderStopIsNotTheAnswerBeforeTheStationHasTakenTheOrder) {
  on_.on_vehicle(true, {"button"});
  on_.on_station(Asked::never);
  EXPECT_FALSE(on_.result(late_ - tick));
  on_.on_station(Asked::on);
  EXPECT_EQ(on_.result(late_ - tick)->code, 0);
}

TEST_F(EmergencyStopOrderTest, TellsTheVehicleDirectlyWhenTheStationDoesNotTakeIt) {
  EXPECT_FALSE(on_.direct(late_ - tick));
  EXPECT_EQ(on_.direct(late_), true);
  EXPECT_EQ(off_.direct(late_), false);
  on_.on_station(Asked::off);  // it runs, but does not take it
  EXPECT_EQ(on_.direct(late_), true);
  on_.on_station(Asked::on);
  EXPECT_FALSE(on_.direct(late_));
  EXPECT_FALSE(status_.direct(late_));
}

TEST_F(EmergencyStopOrderTest, IsObeyedWithoutAStation) {
  on_.on_vehicle(true, {"station"});
  EXPECT_FALSE(on_.result(late_ - tick));
  EXPECT_EQ(on_.result(late_)->code, 0);
  EXPECT_THAT(on_.result(late_)->text, HasSubstr("told directly"));
}

TEST_F(EmergencyStopOrderTest, FailsWhenTheVehicleDoesNotConfirm) {
  on_.on_station(Asked::on);
  on_.on_vehicle(false, {});
  EXPECT_FALSE(on_.result(deadline_ - tick));
  EXPECT_EQ(on_.result(deadline_)->code, 1);
  EXPECT_THAT(on_.result(deadline_)->text, HasSubstr("has not confirmed"));
}

TEST_F(EmergencyStopOrderTest, FailsWhenTheVehicleIsNotHeard) {
  on_.on_station(Asked::on);
  EXPECT_EQ(on_.result(deadline_)->code, 1);
  EXPECT_THAT(on_.result(deadline_)->text, HasSubstr("not heard"));
}

TEST_F(EmergencyStopOrderTest, NamesThoseWhoseStopsStillStandAfterARelease) {
  off_.on_station(Asked::off);
  off_.on_vehicle(true, {"button (7)", "other (8)"});
  EXPECT_EQ(off_.result(deadline_)->code, 1);
  EXPECT_THAT(off_.result(deadline_)->text, HasSubstr("of: button (7), other (8)"));
  off_.on_vehicle(false, {});
  EXPECT_EQ(off_.result(deadline_)->code, 0);
}

TEST_F(EmergencyStopOrderTest, StatusAsksForNothingAndTellsBothSides) {
  EXPECT_FALSE(status_.request());
  status_.on_vehicle(true, {"station"});
  EXPECT_FALSE(status_.result(t0));
  status_.on_station(Asked::on);
  EXPECT_EQ(status_.result(t0)->text,
            "emergency stop ON; vehicle stands by emergency stop of: station");
  status_.on_station(Asked::never);
  status_.on_vehicle(false, {});
  EXPECT_EQ(status_.result(t0)->text, "emergency stop never asked for; vehicle may drive");
}

TEST_F(EmergencyStopOrderTest, StatusWithoutAStationOrAVehicleSaysSo) {
  EXPECT_FALSE(status_.result(deadline_ - tick));
  EXPECT_EQ(status_.result(deadline_)->code, 1);
  EXPECT_THAT(status_.result(deadline_)->text, HasSubstr("vehicle not heard"));
  status_.on_vehicle(false, {});
  EXPECT_EQ(status_.result(late_)->code, 0);
  EXPECT_THAT(status_.result(late_)->text, HasSubstr("kept by nobody at the station"));
}

/// Orders that are given on the vehicle's own host.
class StopAtVehicleTest : public EmergencyStopOrderTest {
 protected:
  using Place = EmergencyStopOrder::Place;
  EmergencyStopOrder on_{StopWish::on, t0, wait, Place::vehicle};
  EmergencyStopOrder off_{StopWish::off, t0, wait, Place::vehicle};
  EmergencyStopOrder status_{StopWish::status, t0, wait, Place::vehicle};
};

TEST_F(StopAtVehicleTest, IsPressedAtOnceAndAsksNobody) {
  EXPECT_EQ(on_.direct(t0), true);
  EXPECT_FALSE(on_.request());
  on_.on_vehicle(false, {});
  EXPECT_FALSE(on_.result(t0));
  on_.on_vehicle(true, {"estop (2a)"});
  EXPECT_EQ(on_.result(t0)->code, 0);
  EXPECT_EQ(on_.result(t0)->text,
            "emergency stop ON: the vehicle stands (pressed on its own host; release it there)");
}

TEST_F(StopAtVehicleTest, TheStopOfAnotherIsNotTheAnswer) {
  on_.on_vehicle(true, {"button (7)"});
  EXPECT_FALSE(on_.result(late_));
  on_.on_vehicle(true, {"estop (2a)", "button (7)"});
  EXPECT_EQ(on_.result(t0)->code, 0);
}

TEST_F(StopAtVehicleTest, AStopOfAnotherOrderThatStoodBeforeIsTheAnswerAfterASecondOnly) {
  on_.on_vehicle(true, {"estop (2a)"});
  EXPECT_FALSE(on_.result(late_ - tick));
  EXPECT_EQ(on_.result(late_)->code, 0);
}

TEST_F(StopAtVehicleTest, AReleaseIsSaidToTheVehicleAndToItsRouter) {
  EXPECT_EQ(off_.direct(t0), false);
  EXPECT_EQ(off_.request(), false);
  off_.on_vehicle(true, {"station"});
  EXPECT_FALSE(off_.result(deadline_ - tick));
  off_.on_vehicle(false, {});
  EXPECT_EQ(off_.result(t0)->text, "emergency stop off: the vehicle may drive");
}

TEST_F(StopAtVehicleTest, NamesWhoMustReleaseItThemselves) {
  off_.on_vehicle(true, {"station"});
  EXPECT_EQ(off_.result(deadline_)->code, 1);
  EXPECT_THAT(off_.result(deadline_)->text,
              HasSubstr("of: station; who pressed it and is still received must release it"));
}

TEST_F(StopAtVehicleTest, StatusWaitsForNoStation) {
  EXPECT_FALSE(status_.direct(t0));
  EXPECT_FALSE(status_.request());
  status_.on_vehicle(true, {"station"});
  EXPECT_EQ(status_.result(t0)->text, "vehicle stands by emergency stop of: station");
}

struct Docking : ::testing::Test {
  std::optional<std::string> hear(std::uint32_t run, const char* state,
                                  const char* result = "none") {
    return sut.on_status({run, state, result, 3.2}, now);
  }
  Time now = t0;
  DockOrder sut{DockWish::start, t0, seconds(10)};
};

TEST_F(Docking, IsOrderedUntilItRunsAndFollowedToItsEnd) {
  EXPECT_STREQ(sut.command(), "start");
  EXPECT_FALSE(hear(0, "idle"));
  EXPECT_STREQ(sut.command(), "start");
  EXPECT_EQ(hear(1, "scan"), "3 s: scan");
  EXPECT_EQ(sut.command(), nullptr);
  EXPECT_FALSE(hear(1, "scan"));
  EXPECT_FALSE(sut.result(now));
  (void)hear(1, "done", "docked");
  EXPECT_EQ(sut.result(now)->code, 0);
  EXPECT_EQ(sut.result(now)->text, "docking docked");
}

TEST_F(Docking, AnOlderResultIsNotTheAnswer) {
  (void)hear(4, "done", "docked");
  EXPECT_FALSE(sut.result(now));
  (void)hear(5, "done", "no_dock_found");
  EXPECT_EQ(sut.result(now)->code, 1);
}

TEST_F(Docking, FailsWhenTheVehicleFallsSilent) {
  (void)hear(1, "scan");
  EXPECT_FALSE(sut.result(t0 + seconds(9.9)));
  EXPECT_EQ(sut.result(t0 + seconds(10))->code, 1);
}

TEST_F(Docking, IsCancelledUntilItStands) {
  sut = DockOrder(DockWish::cancel, t0, seconds(10));
  (void)hear(1, "scan");
  EXPECT_STREQ(sut.command(), "cancel");
  EXPECT_FALSE(sut.result(now));
  (void)hear(1, "done", "cancelled");
  EXPECT_EQ(sut.result(now)->text, "docking cancelled");
}

TEST_F(Docking, ToCancelWhatDoesNotRunIsDoneAtOnce) {
  sut = DockOrder(DockWish::cancel, t0, seconds(10));
  EXPECT_FALSE(sut.result(now)) << "nothing is known of it yet";
  (void)hear(0, "idle");
  EXPECT_EQ(sut.result(now)->code, 0);
  EXPECT_EQ(sut.result(now)->text, "docking idle");
}

}  // namespace
}  // namespace tocsin
