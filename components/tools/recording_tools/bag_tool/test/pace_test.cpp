// SPDX-License-Identifier: Apache-2.0
#include "pace.hpp"

#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "player.hpp"

namespace tocsin::bag_tool {
namespace {

constexpr Time t0{std::chrono::hours(5)};
constexpr std::int64_t first = 1'700'000'000'000'000'000;
constexpr std::int64_t second = 1'000'000'000;

TEST(Pace, IsThatOfTheRecording) {
  const Pace sut(1, first, t0);
  EXPECT_EQ(sut.due(first), t0);
  EXPECT_EQ(sut.due(first + second), t0 + seconds(1));
  EXPECT_EQ(sut.recorded_time_ns(t0 + seconds(3)), first + 3 * second);
}

TEST(Pace, IsTwiceAsFastWithARateOfTwo) {
  const Pace sut(2, first, t0);
  EXPECT_EQ(sut.due(first + second), t0 + seconds(0.5));
  EXPECT_EQ(sut.recorded_time_ns(t0 + seconds(0.5)), first + second);
}

TEST(Pace, WhatIsEarlierIsDueAtOnce) {
  const Pace sut(1, first, t0);
  EXPECT_EQ(sut.due(first - second), t0);
  EXPECT_EQ(sut.due(0), t0);
  EXPECT_EQ(sut.recorded_time_ns(t0 - seconds(1)), first);
}

TEST(Pace, TakesTimesThatNoClockShows) {
  const Pace sut(1e-6, 0, t0);
  EXPECT_EQ(sut.due(9'000'000'000'000'000'000), Time::max());
  const Pace fast(1e9, first, t0);
  EXPECT_GE(fast.recorded_time_ns(Time::max()), first);
}

TEST(Later, EndsWithTheLastTime) {
  EXPECT_EQ(later(first, 1.5), first + second + second / 2);
  EXPECT_EQ(later(first, HUGE_VAL), std::numeric_limits<std::int64_t>::max());
}

TEST(EncodedClock, IsSecondsAndNanosecondsInCdr) {
  EXPECT_EQ(encoded_clock(0x0102'0304LL * second + 5),
            (std::vector<std::uint8_t>{0, 1, 0, 0, 4, 3, 2, 1, 5, 0, 0, 0}));
}

TEST(Remapping, HasAnOldAndANewName) {
  EXPECT_EQ(remapping("/odom:=/old/odom"),
            std::make_pair(std::string("/odom"), std::string("/old/odom")));
  EXPECT_EQ(remapping("odom:=x"), std::make_pair(std::string("/odom"), std::string("/x")));
  for (const std::string text : {"", "/odom", ":=/x", "/odom:=", "/odom:/x"}) {
    EXPECT_THROW((void)remapping(text), ConfigError) << text;
  }
}

}  // namespace
}  // namespace tocsin::bag_tool
