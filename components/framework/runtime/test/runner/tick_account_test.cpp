// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/tick_account.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr Time t0{std::chrono::seconds(1)};

void tick(TickAccount& sut, Duration length) {
  sut.begin(t0);
  sut.end(t0, t0 + length);
}

TEST(TickAccount, CountsAndSumsTicks) {
  TickAccount sut;
  tick(sut, std::chrono::microseconds(10));
  tick(sut, std::chrono::microseconds(30));
  const TickFigures figures = sut.read();
  EXPECT_EQ(figures.ticks, 2U);
  EXPECT_EQ(figures.total, std::chrono::microseconds(40));
}

TEST(TickAccount, LongestIsSinceTheLastReading) {
  TickAccount sut;
  tick(sut, std::chrono::microseconds(30));
  EXPECT_EQ(sut.read().longest, std::chrono::microseconds(30));
  tick(sut, std::chrono::microseconds(10));
  EXPECT_EQ(sut.read().longest, std::chrono::microseconds(10));
}

TEST(TickAccount, TellsSinceWhenATickRuns) {
  TickAccount sut;
  EXPECT_FALSE(sut.read().running_since);
  sut.begin(t0);
  EXPECT_EQ(sut.read().running_since, t0);
  sut.end(t0, t0 + Duration{1});
  EXPECT_FALSE(sut.read().running_since);
}

TEST(TickAccount, QuantileIsABoundAtMostTwiceTooLarge) {
  TickAccount sut;
  for (int i = 0; i < 99; ++i) tick(sut, std::chrono::microseconds(10));
  tick(sut, std::chrono::milliseconds(10));
  const TickFigures figures = sut.read();
  EXPECT_GE(figures.quantile(0.99, {}), std::chrono::microseconds(10));
  EXPECT_LE(figures.quantile(0.99, {}), std::chrono::microseconds(20));
  EXPECT_EQ(figures.quantile(1.0, {}), std::chrono::milliseconds(10));
}

TEST(TickAccount, QuantileLooksOnlyAtTicksSinceTheEarlierFigures) {
  TickAccount sut;
  tick(sut, std::chrono::milliseconds(10));
  const TickFigures earlier = sut.read();
  EXPECT_EQ(sut.read().quantile(0.99, earlier), Duration{0});
  tick(sut, std::chrono::microseconds(10));
  EXPECT_LE(sut.read().quantile(0.99, earlier), std::chrono::microseconds(20));
}

TEST(TickAccount, AnOddClockDoesNotBreakTheBuckets) {
  TickAccount sut;
  tick(sut, Duration{-5});
  tick(sut, std::chrono::hours(24));
  EXPECT_EQ(sut.read().ticks, 2U);
}

}  // namespace
}  // namespace tocsin
