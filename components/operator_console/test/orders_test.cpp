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
const Time deadline = t0 + seconds(5);

TEST(EmergencyStopOrder, IsObeyedWhenGroundStationAndVehicleSaySo) {
  EmergencyStopOrder sut(StopWish::on, deadline);
  EXPECT_EQ(sut.request(), true);
  sut.on_kept(true);
  EXPECT_FALSE(sut.verdict(t0));
  sut.on_vehicle(false);
  EXPECT_FALSE(sut.verdict(t0));
  sut.on_vehicle(true);
  ASSERT_TRUE(sut.verdict(t0));
  EXPECT_EQ(sut.verdict(t0)->code, 0);
}

TEST(EmergencyStopOrder, FailsWhenTheVehicleDoesNotConfirm) {
  EmergencyStopOrder sut(StopWish::off, deadline);
  sut.on_kept(false);
  sut.on_vehicle(true);
  EXPECT_FALSE(sut.verdict(deadline - std::chrono::nanoseconds(1)));
  EXPECT_EQ(sut.verdict(deadline)->code, 1);
  EXPECT_THAT(sut.verdict(deadline)->text, HasSubstr("vehicle has not confirmed"));
}

TEST(EmergencyStopOrder, FailsWhenNobodyKeepsIt) {
  const EmergencyStopOrder sut(StopWish::on, deadline);
  EXPECT_THAT(sut.verdict(deadline)->text, HasSubstr("nobody"));
}

TEST(EmergencyStopOrder, StatusAsksForNothingAndTellsBothSides) {
  EmergencyStopOrder sut(StopWish::status, deadline);
  EXPECT_FALSE(sut.request());
  sut.on_vehicle(true);
  EXPECT_FALSE(sut.verdict(t0));
  sut.on_kept(true);
  EXPECT_THAT(sut.verdict(t0)->text, HasSubstr("ON; vehicle stands"));
  EXPECT_EQ(EmergencyStopOrder(StopWish::status, deadline).verdict(deadline)->code, 1);
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
  EXPECT_FALSE(sut.verdict(now));
  (void)hear(1, "done", "docked");
  EXPECT_EQ(sut.verdict(now)->code, 0);
  EXPECT_EQ(sut.verdict(now)->text, "docking docked");
}

TEST_F(Docking, AnOlderResultIsNotTheAnswer) {
  (void)hear(4, "done", "docked");
  EXPECT_FALSE(sut.verdict(now));
  (void)hear(5, "done", "no_dock_found");
  EXPECT_EQ(sut.verdict(now)->code, 1);
}

TEST_F(Docking, FailsWhenTheVehicleFallsSilent) {
  (void)hear(1, "scan");
  EXPECT_FALSE(sut.verdict(t0 + seconds(9.9)));
  EXPECT_EQ(sut.verdict(t0 + seconds(10))->code, 1);
}

TEST_F(Docking, IsCancelledUntilItStands) {
  sut = DockOrder(DockWish::cancel, t0, seconds(10));
  (void)hear(1, "scan");
  EXPECT_STREQ(sut.command(), "cancel");
  EXPECT_FALSE(sut.verdict(now));
  (void)hear(1, "done", "cancelled");
  EXPECT_EQ(sut.verdict(now)->text, "docking cancelled");
}

TEST_F(Docking, StatusTellsTheStateAtOnce) {
  sut = DockOrder(DockWish::status, t0, seconds(10));
  EXPECT_EQ(sut.command(), nullptr);
  (void)hear(1, "aligned_far");
  EXPECT_EQ(sut.verdict(now)->text, "docking aligned_far");
}

}  // namespace
}  // namespace tocsin
