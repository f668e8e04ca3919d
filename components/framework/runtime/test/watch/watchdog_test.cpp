// SPDX-License-Identifier: Apache-2.0
#include "watch/watchdog.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t mib = 1024 * 1024;
const WatchLimits limits{seconds(5), 100 * mib};
const Time t0{seconds(1000)};

/// Looks once a second at what a test changes.
class WatchdogTest : public ::testing::Test {
 protected:
  /// The last finding of that many seconds.
  std::optional<WatchFinding> watch(int for_s) {
    std::optional<WatchFinding> found;
    for (int i = 0; i < for_s; ++i) {
      now_ += seconds(1);
      found = sut_.look(now_, seen_, resident_);
    }
    return found;
  }
  ActivitySight& see(Duty duty, const char* name) {
    seen_.push_back({name, duty, name, 0, 0, false});
    return seen_.back();
  }

  Watchdog sut_{limits};
  Time now_ = t0;
  std::vector<ActivitySight> seen_;
  std::uint64_t resident_ = 20 * mib;
};

TEST_F(WatchdogTest, AReceptionThatHearsNothingIsFine) {
  see(Duty::reception, "reception at UDP 7411");
  EXPECT_FALSE(watch(60));
}

TEST_F(WatchdogTest, OneThatIsStuckWithAPacketIsAFindingAndThenTheEnd) {
  see(Duty::reception, "reception at UDP 7411").begun = 1;
  EXPECT_FALSE(watch(5));
  const auto found = watch(1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "reception at UDP 7411 is stuck with one packet for 5.0 s");
  EXPECT_FALSE(found->is_final);
  EXPECT_FALSE(watch(4)->is_final);
  EXPECT_TRUE(watch(1)->is_final);
}

TEST_F(WatchdogTest, OneThatIsBusyWithPacketAfterPacketIsFine) {
  ActivitySight& reception = see(Duty::reception, "reception at UDP 7411");
  reception.unread = true;
  for (int i = 0; i < 60; ++i) {
    reception.begun = static_cast<std::uint64_t>(i) + 1;
    reception.ended = static_cast<std::uint64_t>(i);
    EXPECT_FALSE(watch(1)) << i;
  }
}

TEST_F(WatchdogTest, OneThatLeavesPacketsUnreadIsDeaf) {
  ActivitySight& reception = see(Duty::reception, "reception at UDP 7411");
  EXPECT_FALSE(watch(60));
  reception.unread = true;
  EXPECT_FALSE(watch(4));
  const auto found = watch(3);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->text, HasSubstr("reception at UDP 7411 is deaf: it has left packets unread"));
}

TEST_F(WatchdogTest, ATimerThatAnnouncesNothingStandsStill) {
  ActivitySight& timer = see(Duty::announcements, "timer of the link's participant");
  for (int i = 1; i < 30; ++i) {
    timer.begun = timer.ended = static_cast<std::uint64_t>(i / 2);  // each 2 s
    EXPECT_FALSE(watch(1)) << i;
  }
  const auto found = watch(6);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->text, HasSubstr("timer of the link's participant stands still"));
}

TEST_F(WatchdogTest, WhatGoesOnAgainIsForgiven) {
  ActivitySight& reception = see(Duty::reception, "reception at UDP 7411");
  reception.begun = 1;
  EXPECT_TRUE(watch(7));
  reception.ended = 1;
  EXPECT_FALSE(watch(1));
  EXPECT_FALSE(watch(60));
}

TEST_F(WatchdogTest, AProcessThatWasStoppedItselfIsGivenItsTimeAnew) {
  see(Duty::reception, "reception at UDP 7411").begun = 1;
  EXPECT_FALSE(watch(4));
  now_ += seconds(3600);
  EXPECT_FALSE(watch(5));
  EXPECT_TRUE(watch(2));
}

TEST_F(WatchdogTest, AnActivityThatIsGoneIsForgotten) {
  see(Duty::reception, "reception at UDP 7411").begun = 1;
  EXPECT_FALSE(watch(4));
  const auto gone = seen_;
  seen_.clear();
  EXPECT_FALSE(watch(1));
  seen_ = gone;
  EXPECT_FALSE(watch(5));
}

TEST_F(WatchdogTest, TellsTheOneThatHasStoodLongest) {
  see(Duty::reception, "first").begun = 1;
  EXPECT_FALSE(watch(2));
  see(Duty::reception, "second").begun = 1;
  EXPECT_THAT(watch(9)->text, HasSubstr("first"));
}

TEST_F(WatchdogTest, NamesTheOneThatHoldsAPacketWhoeverWaitsForIt) {
  see(Duty::announcements, "timer");
  EXPECT_FALSE(watch(1));
  see(Duty::reception, "reception").begun = 1;
  EXPECT_THAT(watch(7)->text, HasSubstr("reception"));
}

TEST_F(WatchdogTest, TooMuchMemoryIsTheEndAtOnce) {
  resident_ = 101 * mib;
  const auto found = watch(1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "101 MiB resident, more than 100");
  EXPECT_TRUE(found->is_final);
}

}  // namespace
}  // namespace tocsin
