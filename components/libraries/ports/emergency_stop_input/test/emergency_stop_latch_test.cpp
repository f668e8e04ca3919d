// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_latch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Writer = EmergencyStopLatch::Writer;

const Writer station{1, true, "gcs"};
const Writer restarted_station{2, true, "gcs"};
const Writer button{7, false, "button"};
const Writer other{8, false, "other"};

class EmergencyStopLatchTest : public ::testing::Test {
 protected:
  void press(const Writer& writer) { sut_.press(writer); }
  void release(const Writer& writer) {
    sut_.release(writer, [this](std::uint64_t id) { return gone_.count(id) == 0; });
  }
  void goes(const Writer& writer) { gone_.insert(writer.id); }

  EmergencyStopLatch sut_;
  std::set<std::uint64_t> gone_;
};

TEST_F(EmergencyStopLatchTest, DoesNotStandAtFirst) {
  EXPECT_FALSE(sut_.stands());
  EXPECT_THAT(sut_.others(), IsEmpty());
}

TEST_F(EmergencyStopLatchTest, StandsUntilTheWriterThatPressedReleases) {
  for (const Writer& writer : {station, button}) {
    press(writer);
    press(writer);
    EXPECT_TRUE(sut_.stands());
    release(writer);
    EXPECT_FALSE(sut_.stands());
  }
}

TEST_F(EmergencyStopLatchTest, TheFalseOfAnotherReleasesNothing) {
  press(station);
  release(button);
  EXPECT_TRUE(sut_.stands());
  EXPECT_TRUE(sut_.stands_by_station());
  release(station);
  press(button);
  release(other);
  EXPECT_TRUE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, StandsUntilAllHaveReleased) {
  press(station);
  press(button);
  release(station);
  EXPECT_TRUE(sut_.stands());
  EXPECT_FALSE(sut_.stands_by_station());
  release(button);
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, ARestartedStationReleasesWhatItPressedBefore) {
  press(station);
  goes(station);
  EXPECT_TRUE(sut_.stands());
  release(restarted_station);
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, AStopOfTheDeadStaysUntilTheStationReleases) {
  press(button);
  goes(button);
  release(other);
  EXPECT_TRUE(sut_.stands());
  release(station);
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, TheStationDoesNotReleaseAStopOfTheLiving) {
  press(button);
  press(other);
  goes(other);
  release(station);
  EXPECT_THAT(sut_.others(), ElementsAre("button"));
}

TEST_F(EmergencyStopLatchTest, AWriterThatTurnsOutToBeTheStationIsCountedOnce) {
  press({station.id, false, ""});  // heard before it was known whose it is
  press(station);
  release(station);
  EXPECT_FALSE(sut_.stands());
  press({station.id, false, ""});
  release(station);
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, NamesTheOthersWhoseStopsStand) {
  press(other);
  press(station);
  press(button);
  EXPECT_THAT(sut_.others(), ElementsAre("button", "other"));
}

TEST_F(EmergencyStopLatchTest, WhatStoodBeforeARestartStandsUntilTheStationReleases) {
  press(station);
  const auto by_station = sut_.memory();
  sut_ = {};
  sut_.restore(by_station);
  EXPECT_TRUE(sut_.stands_by_station());
  release(button);
  EXPECT_TRUE(sut_.stands());
  release(station);
  EXPECT_FALSE(sut_.stands());

  press(button);
  const auto by_button = sut_.memory();
  sut_ = {};
  sut_.restore(by_button);
  EXPECT_TRUE(sut_.stands());
  EXPECT_FALSE(sut_.stands_by_station());
  release(button);  // known by its id only, and the id was not kept
  EXPECT_TRUE(sut_.stands());
  release(station);
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, NothingStandsAgainWhenNothingStood) {
  sut_.restore(EmergencyStopLatch().memory());
  EXPECT_FALSE(sut_.stands());
}

TEST_F(EmergencyStopLatchTest, CountsSixtyFourWritersAndForgetsNoFurtherOne) {
  for (std::uint64_t id = 100; id < 165; ++id) press({id, false, "one of many"});
  for (std::uint64_t id = 100; id < 164; ++id) release({id, false, ""});
  EXPECT_TRUE(sut_.stands());  // by the 65th
  release({164, false, ""});
  EXPECT_TRUE(sut_.stands());
  release(station);
  EXPECT_FALSE(sut_.stands());
}

}  // namespace
}  // namespace tocsin
