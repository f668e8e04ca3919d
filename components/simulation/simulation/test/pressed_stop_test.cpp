// SPDX-License-Identifier: Apache-2.0
#include "simulation/pressed_stop.hpp"

#include <gtest/gtest.h>

namespace tocsin::simulation {
namespace {

const Time t0 = Time{} + seconds(100);
constexpr Duration tick{1};
const Time settled = t0 + PressedStop::settles;

class PressedStopTest : public ::testing::Test {
 protected:
  PressedStopTest() { sut_.on_station(true, t0); }
  PressedStop sut_;
};

TEST_F(PressedStopTest, WhatWasWrittenBeforeThePressTellsNothing) {
  EXPECT_TRUE(sut_.is_reported(t0 + seconds(60)));
  sut_.on_crossed(settled - tick, t0 + seconds(30));
  EXPECT_TRUE(sut_.is_reported(t0 + seconds(60)));
}

TEST_F(PressedStopTest, IsOwedSoonAfterSomethingCrosses) {
  sut_.on_crossed(settled, settled);
  const Time due = settled + PressedStop::reported_within;
  EXPECT_TRUE(sut_.is_reported(due - tick));
  EXPECT_FALSE(sut_.is_reported(due));
  EXPECT_TRUE(sut_.on_link(true, due));
  EXPECT_TRUE(sut_.is_reported(due));
}

TEST_F(PressedStopTest, ARouterThatBeginsOwesNothingUntilSomethingCrossesAgain) {
  sut_.on_crossed(settled, settled);
  sut_.on_router();
  EXPECT_TRUE(sut_.is_reported(settled + seconds(60)));
  sut_.on_crossed(settled + seconds(60), settled + seconds(60));
  EXPECT_FALSE(sut_.is_reported(settled + seconds(61)));
}

TEST_F(PressedStopTest, IsNotDroppedBeforeTheStationReleases) {
  EXPECT_TRUE(sut_.on_link(true, settled));
  EXPECT_FALSE(sut_.on_link(false, settled + tick));
  EXPECT_TRUE(sut_.on_link(true, settled + 2 * tick));
  sut_.on_station(false, settled + 3 * tick);
  EXPECT_TRUE(sut_.on_link(false, settled + 4 * tick));
  EXPECT_TRUE(sut_.is_reported(settled + seconds(60)));
}

TEST_F(PressedStopTest, AnEarlierStopMayEndWhileTheNextIsOnItsWay) {
  EXPECT_TRUE(sut_.on_link(true, settled - tick));
  EXPECT_TRUE(sut_.on_link(false, settled - tick));
}

}  // namespace
}  // namespace tocsin::simulation
