// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/thinning.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const Time t0{std::chrono::hours(1)};
using std::chrono::milliseconds;

int passed(RateLimit& sut, int count, Duration period) {
  int n = 0;
  for (int i = 0; i < count; ++i) n += sut.pass(t0 + i * period) ? 1 : 0;
  return n;
}

TEST(RateLimit, PassesAStreamOfItsOwnRateWhole) {
  RateLimit sut(milliseconds(20));
  EXPECT_EQ(passed(sut, 1000, milliseconds(20)), 1000);
  EXPECT_EQ(sut.dropped(), 0U);
}

TEST(RateLimit, HalvesAStreamOfTwiceItsRate) {
  RateLimit sut(milliseconds(20));
  EXPECT_NEAR(passed(sut, 1000, milliseconds(10)), 500, 2);
  EXPECT_NEAR(static_cast<double>(sut.dropped()), 500, 2);
}

TEST(RateLimit, ForgivesJitterOfOneInterval) {
  RateLimit sut(milliseconds(20));
  EXPECT_TRUE(sut.pass(t0));
  EXPECT_TRUE(sut.pass(t0));
  EXPECT_FALSE(sut.pass(t0 + milliseconds(19)));
  EXPECT_TRUE(sut.pass(t0 + milliseconds(20)));
}

TEST(RateLimit, DoesNotSaveUpWhileNothingIsWritten) {
  RateLimit sut(milliseconds(20));
  EXPECT_TRUE(sut.pass(t0));
  const Time later = t0 + seconds(10);
  EXPECT_TRUE(sut.pass(later));
  EXPECT_TRUE(sut.pass(later));
  EXPECT_FALSE(sut.pass(later));
}

TEST(Separation, ZeroPassesEverything) {
  Separation sut(Duration::zero());
  EXPECT_TRUE(sut.pass(1, t0));
  EXPECT_TRUE(sut.pass(1, t0));
}

TEST(Separation, PassesOnlySoLongAfterTheOneItPassed) {
  Separation sut(milliseconds(100));
  EXPECT_TRUE(sut.pass(1, t0));
  EXPECT_FALSE(sut.pass(1, t0 + milliseconds(99)));
  EXPECT_TRUE(sut.pass(1, t0 + milliseconds(100)));
  EXPECT_FALSE(sut.pass(1, t0 + milliseconds(199)));
  EXPECT_EQ(sut.dropped(), 2U);
}

TEST(Separation, IsKeptForEachWriterApart) {
  Separation sut(milliseconds(100));
  EXPECT_TRUE(sut.pass(1, t0));
  EXPECT_TRUE(sut.pass(2, t0));
  EXPECT_FALSE(sut.pass(1, t0 + milliseconds(1)));
  sut.forget(1);
  EXPECT_TRUE(sut.pass(1, t0 + milliseconds(1)));
}

TEST(DeadlineWatch, CountsNothingBeforeTheFirstSample) {
  EXPECT_EQ(DeadlineWatch(milliseconds(100)).missed(t0), 0U);
}

TEST(DeadlineWatch, ASampleAtTheDeadlineIsInTime) {
  DeadlineWatch sut(milliseconds(100));
  sut.on_sample(t0);
  EXPECT_EQ(sut.missed(t0 + milliseconds(100)), 0U);
  EXPECT_EQ(sut.missed(t0 + milliseconds(100) + Duration{1}), 1U);
}

TEST(DeadlineWatch, CountsEachPeriodOfSilenceAndKeepsTheCount) {
  DeadlineWatch sut(milliseconds(100));
  sut.on_sample(t0);
  EXPECT_EQ(sut.missed(t0 + milliseconds(350)), 3U);
  sut.on_sample(t0 + milliseconds(350));
  sut.on_sample(t0 + milliseconds(400));
  EXPECT_EQ(sut.missed(t0 + milliseconds(400)), 3U);
  EXPECT_EQ(sut.last(), t0 + milliseconds(400));
}

TEST(DeadlineWatch, ANewPeriodBeginsWhenItIsSetAndWhatWasMissedStaysCounted) {
  DeadlineWatch sut(milliseconds(100));
  sut.on_sample(t0);
  sut.change(milliseconds(50), t0 + milliseconds(350));
  EXPECT_EQ(sut.missed(t0 + milliseconds(400)), 3U);
  EXPECT_EQ(sut.missed(t0 + milliseconds(401)), 4U);
  sut.change(Duration::max(), t0 + milliseconds(401));
  EXPECT_EQ(sut.missed(t0 + seconds(10)), 4U);
}

TEST(RateLimit, ANewRateHoldsFromTheNextSampleOn) {
  RateLimit sut(milliseconds(100));
  EXPECT_EQ(passed(sut, 10, milliseconds(10)), 2);
  sut.change(milliseconds(10));
  int n = 0;
  for (int i = 100; i < 200; ++i) n += sut.pass(t0 + i * milliseconds(10)) ? 1 : 0;
  EXPECT_EQ(n, 100);
}

TEST(DeadlineWatch, AnInfinitePeriodIsNeverMissed) {
  DeadlineWatch sut(Duration::max());
  sut.on_sample(t0);
  EXPECT_EQ(sut.missed(t0 + seconds(1e6)), 0U);
}

}  // namespace
}  // namespace tocsin
