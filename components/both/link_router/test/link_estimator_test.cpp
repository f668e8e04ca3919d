// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr Duration clock_difference = -std::chrono::minutes(10);
constexpr WireCost small{1, 400};
constexpr WireCost bulk{10, 10000};

class LinkEstimatorTest : public ::testing::Test {
 protected:
  /// Sent at `now`, arrived after `crossing`, and acknowledged at once.
  Duration cross(const WireCost& cost, Duration crossing) {
    return cross(cost, crossing, crossing);
  }
  Duration cross(const WireCost& cost, Duration crossing, Duration acknowledged) {
    const Time expected = sut.on_sent(cost, now);
    return sut.on_received({cost, now, expected, now + crossing + clock_difference, true},
                           now + acknowledged);
  }
  LinkEstimator sut;
  Time now = t0;
};

TEST(WindowedMinimum, ForgetsAfterTheWindow) {
  WindowedMinimum sut(std::chrono::seconds(10));
  EXPECT_FALSE(sut.value());
  sut.add(3 * ms, t0);
  sut.add(5 * ms, t0 + std::chrono::seconds(5));
  EXPECT_EQ(sut.value(), 3 * ms);
  sut.add(6 * ms, t0 + std::chrono::seconds(10));
  EXPECT_EQ(sut.value(), 5 * ms);
  sut.add(9 * ms, t0 + std::chrono::seconds(60));
  EXPECT_EQ(sut.value(), 9 * ms) << "a long silence leaves nothing";
}

TEST_F(LinkEstimatorTest, CountsDelaysOverTheLeastOneWhateverTheClocksShow) {
  EXPECT_EQ(cross(small, 5 * ms), 0 * ms);
  EXPECT_EQ(cross(small, 25 * ms), 20 * ms);
  EXPECT_EQ(cross(small, 2 * ms), 0 * ms);
  EXPECT_EQ(cross(small, 25 * ms), 23 * ms);
}

TEST_F(LinkEstimatorTest, ForgetsAStepOfAClockWithTheWindow) {
  (void)cross(small, 5 * ms);
  const Duration step = std::chrono::seconds(100);
  EXPECT_EQ(cross(small, 5 * ms + step, 30 * ms), 30 * ms) << "it was acknowledged by then";
  for (int i = 0; i < 70; ++i, now += 1000 * ms) (void)cross(small, 5 * ms + step, 30 * ms);
  EXPECT_EQ(cross(small, 6 * ms + step, 30 * ms), 1 * ms);
}

TEST_F(LinkEstimatorTest, ExpectsAnAnswerWhenAnswersCameLatelyWithinABound) {
  for (int i = 0; i < 100; ++i, now += 100 * ms) (void)cross(small, 2 * ms, 300 * ms);
  EXPECT_NEAR(to_seconds(sut.expected_answer()), 0.3, 0.01);
  for (int i = 0; i < 100; ++i, now += 100 * ms) {
    (void)cross(small, 2 * ms, (i % 2 == 0 ? 200 : 400) * ms);
  }
  EXPECT_NEAR(to_seconds(sut.expected_answer()), 0.7, 0.05) << "its spread is 0.1 s";
  (void)cross(bulk, 2 * ms, 20'000 * ms);
  EXPECT_LT(sut.expected_answer(), 800 * ms) << "bulk waits for itself";
  (void)cross(small, 2 * ms, 20'000 * ms);
  EXPECT_EQ(sut.expected_answer(), seconds(answer_max_s));
}

TEST_F(LinkEstimatorTest, AForgedArrivalHoldsNothingBackForLong) {
  for (int i = 0; i < 20; ++i, now += 200 * ms) {
    (void)cross(small, 2 * ms);
    (void)cross(bulk, 52 * ms);
  }
  (void)cross(small, -std::chrono::hours(1), 100 * ms);
  for (int i = 0; i < 5; ++i, now += 200 * ms) {
    (void)cross(small, 2 * ms, 100 * ms);
    (void)cross(bulk, 52 * ms, 100 * ms);
    EXPECT_LE(sut.backlog(now + 100 * ms), 100 * ms);
  }
}

TEST_F(LinkEstimatorTest, LearnsTheCapacityFromBulk) {
  (void)cross(small, 2 * ms);
  for (int i = 0; i < 30; ++i, now += 200 * ms) (void)cross(bulk, 52 * ms);
  EXPECT_NEAR(sut.capacity_bytes_per_s(), 200000, 2000) << "10 kB in 50 ms";
  for (int i = 0; i < 8; ++i, now += 300 * ms) (void)cross(bulk, 202 * ms);
  EXPECT_NEAR(sut.capacity_bytes_per_s(), 50000, 2000) << "a fall is believed at once";
}

TEST_F(LinkEstimatorTest, WhatWasSentBeforeAFreezeTellsNothingOfTimes) {
  (void)cross(small, 2 * ms);
  for (int i = 0; i < 30; ++i, now += 200 * ms) (void)cross(bulk, 52 * ms);
  const double before = sut.capacity_bytes_per_s();
  const Time expected = sut.on_sent(bulk, now);
  const Time thawed = now + std::chrono::seconds(5);
  sut.on_frozen(thawed);
  EXPECT_FALSE(sut.is_silent(thawed + 10 * ms)) << "nobody was here to hear the peer";
  (void)sut.on_received({bulk, now, expected, thawed + 52 * ms + clock_difference, true},
                        thawed + 52 * ms);
  EXPECT_EQ(sut.capacity_bytes_per_s(), before);
  EXPECT_EQ(sut.backlog(thawed + 52 * ms), 0 * ms);
  now = thawed + 52 * ms;
  for (int i = 0; i < 8; ++i, now += 300 * ms) (void)cross(bulk, 202 * ms);
  EXPECT_NEAR(sut.capacity_bytes_per_s(), 50000, 2000) << "what is sent later does";
}

TEST_F(LinkEstimatorTest, LearnsNoCapacityWithoutSmallSamples) {
  const double before = sut.capacity_bytes_per_s();
  for (int i = 0; i < 9; ++i, now += 200 * ms) EXPECT_EQ(cross(bulk, 52 * ms), 0 * ms);
  EXPECT_EQ(sut.capacity_bytes_per_s(), before) << "52 ms may be the difference of the clocks";
}

TEST_F(LinkEstimatorTest, TheBacklogDrainsAtTheCapacity) {
  EXPECT_EQ(sut.backlog(now), 0 * ms);
  (void)sut.on_sent(bulk, now);
  EXPECT_EQ(sut.backlog(now), seconds(10000 / capacity_start_bytes_per_s));
  EXPECT_EQ(sut.backlog(now + 40 * ms), 60 * ms);
  EXPECT_EQ(sut.backlog(now + 200 * ms), 0 * ms);
}

TEST_F(LinkEstimatorTest, TheFreeRateIsThatOfTheFastestBulkOfTenSeconds) {
  EXPECT_EQ(sut.free_bytes_per_s(), free_start_bytes_per_s);
  (void)cross(small, 2 * ms);
  for (int i = 0; i < 20; ++i, now += 200 * ms) {
    (void)cross(bulk, i == 3 ? 12 * ms : 52 * ms);  // the others share the air with somebody
  }
  EXPECT_NEAR(sut.free_bytes_per_s(), 1e6, 1e4) << "10 kB in 10 ms";
  for (int i = 0; i < 100; ++i, now += 200 * ms) (void)cross(bulk, 52 * ms);
  EXPECT_NEAR(sut.free_bytes_per_s(), 2e5, 2e3) << "the vehicle has driven away";
}

TEST_F(LinkEstimatorTest, WhatIsSentOfAShareHoldsBackWhatWaits) {
  EXPECT_TRUE(std::isinf(sut.share_bytes_per_s()));
  sut.set_airtime_share(0.1);
  EXPECT_DOUBLE_EQ(sut.share_bytes_per_s(), 0.1 * free_start_bytes_per_s);
  (void)sut.on_sent(bulk, now, false);
  EXPECT_EQ(sut.backlog(now), seconds(10000 / capacity_start_bytes_per_s)) << "what is urgent";
  now += 1000 * ms;
  (void)sut.on_sent(bulk, now);
  const Duration whole = seconds(10000 / sut.share_bytes_per_s());
  EXPECT_GE(sut.backlog(now), whole / 2);
  EXPECT_LE(sut.backlog(now), whole * 3 / 2);
  sut.set_airtime_share(std::nullopt);
  (void)sut.on_sent(bulk, now + 1000 * ms);
  EXPECT_EQ(sut.backlog(now + 1000 * ms), seconds(10000 / capacity_start_bytes_per_s));
}

TEST_F(LinkEstimatorTest, AShareIsSpentAtItsRateInTurnsOfSeveralLengths) {
  sut.set_airtime_share(0.1);
  std::set<Duration> waits;
  const Time begin = now;
  for (int i = 0; i < 1000; ++i) {
    (void)sut.on_sent(bulk, now);
    waits.insert(sut.backlog(now));
    now += sut.backlog(now);
  }
  EXPECT_NEAR(to_seconds(now - begin), 1000 * 10000 / sut.share_bytes_per_s(), 1);
  EXPECT_GT(waits.size(), 900U);
}

TEST_F(LinkEstimatorTest, IsSilentOnlyAfterSeveralUnansweredAndTheTime) {
  const Duration limit = silent_after;
  (void)cross(small, 2 * ms);
  sut.on_all_settled();
  now += 10 * limit;
  EXPECT_FALSE(sut.is_silent(now)) << "nothing was sent";
  const Time begin = now;
  (void)sut.on_sent(small, now);
  (void)sut.on_sent(small, now);
  EXPECT_FALSE(sut.is_silent(begin + 10 * limit)) << "two may be bad luck";
  (void)sut.on_sent(small, now);
  EXPECT_FALSE(sut.is_silent(begin + limit));
  EXPECT_TRUE(sut.is_silent(begin + limit + Duration{1}));
  (void)cross(small, 2 * ms);
  EXPECT_FALSE(sut.is_silent(now));
}

TEST_F(LinkEstimatorTest, StartsOverWithHalfOfWhatWasMeasuredAndAnEmptyQueue) {
  (void)cross(small, 2 * ms);
  for (int i = 0; i < 30; ++i, now += 200 * ms) (void)cross(bulk, 52 * ms);
  (void)sut.on_sent(bulk, now);
  sut.start_over(now);
  EXPECT_EQ(sut.backlog(now), 0 * ms);
  EXPECT_NEAR(sut.capacity_bytes_per_s(), 100000, 1000);
  for (int i = 0; i < 100; ++i) sut.start_over(now);
  EXPECT_NEAR(sut.capacity_bytes_per_s(), 100000, 1000) << "nothing was measured in between";
}

}  // namespace
}  // namespace tocsin::router
