// SPDX-License-Identifier: Apache-2.0
// What a station says of the emergency stop, and what stands on a vehicle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "link_router/stop_listener.hpp"
#include "link_router/stop_speaker.hpp"
#include "station_side.hpp"

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

class StopExchangeTest : public ::testing::Test {
 protected:
  [[nodiscard]] bool stands() {
    vehicle_.follow(now_);
    return vehicle_.stands();
  }
  StationSide station_{1};
  StopListener vehicle_;
  Time now_ = Time(seconds(1000));
};

TEST_F(StopExchangeTest, APressStandsAndItsReleaseEndsIt) {
  station_.host(false, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_FALSE(stands());
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_TRUE(stands());
  EXPECT_THAT(vehicle_.stopped_by(), ElementsAre("station"));
  station_.host(false, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_FALSE(stands());
  EXPECT_THAT(vehicle_.stopped_by(), IsEmpty());
}

TEST_F(StopExchangeTest, OneValueOfAnyAgeIsEnough) {
  station_.host(true, now_);
  for (int i = 0; i < 100; ++i) (void)station_.said(now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_TRUE(stands());
}

TEST_F(StopExchangeTest, NothingThatAnotherSaysReleasesIt) {
  station_.host(true, now_);
  const ReceivedStop pressed = station_.said(now_);
  vehicle_.on_value(pressed);
  StationSide forger(2);
  forger.host(true, now_);
  (void)forger.said(now_);
  forger.host(false, now_);
  ReceivedStop forged = forger.said(now_);
  forged.value.keys.push_back(pressed.value.locks.front());
  for (const std::uint64_t number : {1ULL, ~0ULL}) {
    forged.value.number = number;
    forged.value.host = pressed.value.host;
    forged.router = pressed.router;
    vehicle_.on_value(forged);
    EXPECT_TRUE(stands());
  }
}

TEST_F(StopExchangeTest, AForgersPressIsEndedByItsKeyOrAtTheVehicle) {
  StationSide forger(2);
  forger.host(true, now_);
  vehicle_.on_value(forger.said(now_));
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  station_.host(false, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_TRUE(stands());
  now_ += seconds(2);
  vehicle_.release_left(now_);
  EXPECT_TRUE(stands()) << "it is still received";
  now_ += milliseconds(1);
  vehicle_.release_left(now_);
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, AReplayedPressEndsWhenItsStationHearsOfIt) {
  station_.host(true, now_);
  const ReceivedStop pressed = station_.said(now_);
  station_.host(false, now_);
  now_ += seconds(60);
  vehicle_.on_value(pressed);
  EXPECT_TRUE(stands());
  EXPECT_THAT(station_.said(now_).value.keys, IsEmpty());
  station_.speaker.on_report(vehicle_.locks(), now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, ALateReleaseDoesNotEndTheNextPress) {
  station_.host(true, now_);
  station_.host(false, now_);
  const ReceivedStop released = station_.said(now_);
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  vehicle_.on_value(released);
  EXPECT_TRUE(stands());
}

TEST_F(StopExchangeTest, ARestartedStationStandsByTheSamePressAndMayReleaseIt) {
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  StationSide successor(1);
  successor.speaker.restore(station_.speaker.presses());
  successor.host(false, now_);
  vehicle_.on_value(successor.said(now_));
  EXPECT_TRUE(stands()) << "it does not know yet that its host's stop stands";
  successor.host(true, now_);
  vehicle_.on_value(successor.said(now_));
  EXPECT_EQ(vehicle_.locks().size(), 1U);
  successor.host(false, now_);
  vehicle_.on_value(successor.said(now_));
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, APersonsReleaseEndsWhatAnEarlierProcessLeft) {
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  StationSide successor(1);
  successor.speaker.restore(station_.speaker.presses());
  successor.speaker.on_release(now_);
  successor.host(false, now_ + StopSpeaker::release_lasts);
  vehicle_.on_value(successor.said(now_));
  EXPECT_TRUE(stands()) << "that long after the wish nobody expects it";
  successor.speaker.on_release(now_);
  successor.host(false, now_ + milliseconds(1));
  vehicle_.on_value(successor.said(now_));
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, APersonsReleaseEndsNothingWhileTheHostsStopStands) {
  station_.host(true, now_);
  station_.speaker.on_release(now_);
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_TRUE(stands());
  EXPECT_THAT(station_.said(now_).value.keys, IsEmpty());
}

TEST_F(StopExchangeTest, PacketsWithoutAFreshValueAreAStop) {
  vehicle_.on_value(station_.said(now_));
  now_ += seconds(1);
  vehicle_.on_packet({1, now_});
  EXPECT_FALSE(stands());
  now_ += milliseconds(1);
  vehicle_.on_packet({1, now_});
  EXPECT_TRUE(stands());
  EXPECT_THAT(vehicle_.stopped_by(), ElementsAre("gcs1: value not fresh"));
  vehicle_.on_value(station_.said(now_));
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, KnowsNothingAtFirstAndAfterAFreezeUntilAValueOrASecondOfSilence) {
  const auto knows = [this] {
    vehicle_.follow(now_);
    return vehicle_.knows(now_);
  };
  EXPECT_FALSE(knows());
  station_.host(false, now_);
  vehicle_.on_value(station_.said(now_));
  EXPECT_TRUE(knows());
  for (int i = 0; i < 30; ++i, now_ += milliseconds(100)) EXPECT_TRUE(knows());
  now_ += seconds(5);
  EXPECT_FALSE(knows());
  for (int i = 0; i < 9; ++i) {
    now_ += milliseconds(100);
    EXPECT_FALSE(knows());
  }
  now_ += milliseconds(100);
  EXPECT_TRUE(knows()) << "the link is lost";
}

TEST_F(StopExchangeTest, AStopThatStandsIsKnownAtOnce) {
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  StopListener successor;
  successor.restore(vehicle_.memory(), now_);
  successor.follow(now_);
  EXPECT_TRUE(successor.stands());
  EXPECT_TRUE(successor.knows(now_));
}

TEST_F(StopExchangeTest, SilenceIsNoStopButIsTold) {
  EXPECT_EQ(vehicle_.silence(now_), std::nullopt);
  vehicle_.on_value(station_.said(now_));
  now_ += seconds(60);
  EXPECT_FALSE(stands());
  EXPECT_EQ(vehicle_.silence(now_), seconds(60));
}

TEST_F(StopExchangeTest, PacketsOfAPeerThatNeverSaidAValueAreNoStop) {
  vehicle_.on_packet({9, now_});
  now_ += seconds(5);
  vehicle_.on_packet({9, now_});
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, WhatAVehicleSaysPressesNothing) {
  ReceivedStop report = station_.said(now_);
  report.value.role = Role::uxv;
  report.value.stands = true;
  vehicle_.on_value(report);
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, AFloodOfPressesStandsInBoundedMemoryUntilItIsReleasedAtTheVehicle) {
  StationSide forger(2);
  for (int i = 0; i < 250; ++i) {
    forger.host(true, now_);
    vehicle_.on_value(forger.said(now_));
    forger.speaker = StopSpeaker([&] { return StopToken{9, static_cast<std::uint8_t>(i)}; });
  }
  EXPECT_LE(vehicle_.memory().locks.size(), StopListener::most_stops);
  EXPECT_TRUE(vehicle_.memory().more);
  now_ += seconds(3);
  vehicle_.release_left(now_);
  EXPECT_FALSE(stands());
}

TEST_F(StopExchangeTest, StandsOverARestartOfTheVehiclesRouter) {
  station_.host(true, now_);
  vehicle_.on_value(station_.said(now_));
  StopListener successor;
  successor.restore(vehicle_.memory(), now_);
  EXPECT_TRUE(successor.stands());
  station_.host(false, now_);
  successor.on_value(station_.said(now_));
  EXPECT_FALSE(successor.stands());
}

TEST_F(StopExchangeTest, AnIdentityReleasesWhatItHasPressedThoughItsKeyIsLost) {
  StationSide before(1, "CN=/gcs");
  before.host(true, now_);
  vehicle_.on_value(before.said(now_));
  StationSide after(7, "CN=/gcs");
  after.number = before.number;
  StationSide other(8, "CN=/other");
  other.number = 1000;
  vehicle_.on_value(other.said(now_));
  EXPECT_TRUE(stands());
  vehicle_.on_value(after.said(now_));
  EXPECT_FALSE(stands());
  EXPECT_EQ(vehicle_.releases(), 1U);
}

TEST_F(StopExchangeTest, ARecordedValueOfAnIdentityReleasesNothingAndIsNotFresh) {
  StationSide station(1, "CN=/gcs");
  const ReceivedStop idle = station.said(now_);
  station.host(true, now_);
  vehicle_.on_value(station.said(now_));
  now_ += seconds(5);
  ReceivedStop replayed = idle;
  replayed.received = now_;
  vehicle_.on_value(replayed);
  EXPECT_TRUE(stands());
  EXPECT_EQ(vehicle_.silence(now_), seconds(5));
}

}  // namespace
}  // namespace tocsin::router
