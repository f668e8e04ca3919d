// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop/stop_keeper.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0 = Time{} + seconds(100);
constexpr Duration tick{1};

class StopKeeperTest : public ::testing::Test {
 protected:
  /// Says what is due, as the component does.
  std::optional<bool> say(Time now) {
    const auto word = sut_.word(now);
    if (word) sut_.said(now);
    return word;
  }
  void vehicle_stands_by_station() { sut_.on_vehicle(true, true); }
  void vehicle_stands_by_another() { sut_.on_vehicle(true, false); }
  void vehicle_may_drive() { sut_.on_vehicle(false, false); }

  StopKeeper sut_{{}};
};

TEST_F(StopKeeperTest, SaysNothingUntilItIsAsked) {
  vehicle_may_drive();
  EXPECT_FALSE(say(t0));
  EXPECT_EQ(sut_.due(t0), never);
  EXPECT_FALSE(sut_.wanted());
}

TEST_F(StopKeeperTest, RepeatsAStopForEver) {
  sut_.on_request(true, t0);
  EXPECT_EQ(say(t0), true);
  EXPECT_FALSE(say(t0 + seconds(0.2) - tick));
  EXPECT_EQ(sut_.due(t0), t0 + seconds(0.2));
  EXPECT_EQ(say(t0 + seconds(0.2)), true);
  vehicle_stands_by_station();
  EXPECT_EQ(say(t0 + seconds(86400)), true);
}

TEST_F(StopKeeperTest, SaysAChangeAtOnce) {
  sut_.on_request(true, t0);
  (void)say(t0);
  sut_.on_request(false, t0 + tick);
  EXPECT_EQ(say(t0 + tick), false);
  sut_.on_request(true, t0 + 2 * tick);
  EXPECT_EQ(say(t0 + 2 * tick), true);
}

TEST_F(StopKeeperTest, RepeatsAReleaseUntilTheVehicleConfirmsIt) {
  vehicle_stands_by_station();
  sut_.on_request(false, t0);
  EXPECT_EQ(say(t0), false);
  EXPECT_EQ(say(t0 + seconds(0.2)), false);
  vehicle_stands_by_another();
  EXPECT_EQ(say(t0 + seconds(0.4)), false);
  vehicle_may_drive();
  EXPECT_FALSE(say(t0 + seconds(0.6)));
  EXPECT_EQ(sut_.due(t0 + seconds(0.6)), never);
}

TEST_F(StopKeeperTest, DoesNotReleaseAStopThatComesAfterTheConfirmation) {
  sut_.on_request(false, t0);
  (void)say(t0);
  vehicle_may_drive();
  vehicle_stands_by_another();
  EXPECT_FALSE(say(t0 + seconds(1)));
}

TEST_F(StopKeeperTest, AReportOfBeforeTheReleaseIsNoConfirmation) {
  sut_.on_request(true, t0);
  (void)say(t0);
  sut_.on_request(false, t0 + tick);
  vehicle_may_drive();  // it has not received the stop yet
  EXPECT_EQ(say(t0 + tick), false);
  vehicle_may_drive();
  EXPECT_FALSE(say(t0 + seconds(0.5)));
}

TEST_F(StopKeeperTest, AReleaseThatNobodyConfirmsLapses) {
  sut_.on_request(false, t0);
  EXPECT_EQ(say(t0 + seconds(2) - tick), false);
  EXPECT_FALSE(say(t0 + seconds(2)));
  vehicle_stands_by_station();
  EXPECT_FALSE(say(t0 + seconds(100)));
  EXPECT_EQ(sut_.due(t0 + seconds(100)), never);
}

TEST_F(StopKeeperTest, ARepeatedRequestProlongsTheRelease) {
  vehicle_may_drive();
  sut_.on_request(false, t0);
  sut_.on_request(false, t0 + seconds(1));
  EXPECT_EQ(say(t0 + seconds(3) - tick), false);
  EXPECT_FALSE(say(t0 + seconds(3)));
}

TEST_F(StopKeeperTest, ReleasesThoughItKnowsOfNoPress) {
  sut_.on_request(false, t0);
  EXPECT_EQ(say(t0), false);
}

TEST_F(StopKeeperTest, TakesUpItsOwnStopAgainWhenItRemembersNothing) {
  vehicle_stands_by_another();
  EXPECT_FALSE(say(t0));
  vehicle_stands_by_station();
  EXPECT_EQ(sut_.wanted(), true);
  EXPECT_EQ(say(t0), true);
}

TEST_F(StopKeeperTest, TakesUpNothingWhereThereAreOtherStations) {
  StopKeeper::Params params;
  params.only_station = false;
  StopKeeper sut(params);
  sut.on_vehicle(true, true);
  EXPECT_FALSE(sut.word(t0));
}

TEST_F(StopKeeperTest, DoesNotTakeUpAStopThatAPersonHasReleased) {
  sut_.on_request(false, t0);
  vehicle_stands_by_station();
  EXPECT_EQ(sut_.wanted(), false);
}

TEST_F(StopKeeperTest, GoesOnWithARestoredStop) {
  sut_.restore();
  EXPECT_EQ(sut_.wanted(), true);
  EXPECT_EQ(say(t0), true);
}

}  // namespace
}  // namespace tocsin
