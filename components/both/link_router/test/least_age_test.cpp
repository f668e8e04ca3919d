// SPDX-License-Identifier: Apache-2.0
#include "link_router/least_age.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);
constexpr Duration difference = std::chrono::hours(9);  // between the clocks

class LeastAgeTest : public ::testing::Test {
 protected:
  LeastAgeTest() {
    for (int i = 0; i < 60; ++i, now += 100 * ms) (void)age(2 * ms);
  }
  /// Of a sample that was sent so long ago.
  Duration age(Duration real) { return sut.age(now - real - difference, now); }
  /// How long healthy traffic, ten arrivals a second, seems older than `limit`.
  Duration poisoned_for(Duration limit) {
    const Time begin = now;
    while (age(2 * ms) > limit && now - begin < std::chrono::minutes(1)) now += 100 * ms;
    return now - begin;
  }
  LeastAge sut{std::chrono::seconds(30)};
  Time now{std::chrono::hours(20)};
};

TEST_F(LeastAgeTest, IsOverTheLeastWhateverTheClocksShow) {
  EXPECT_EQ(age(2 * ms), 0 * ms);
  EXPECT_EQ(age(302 * ms), 300 * ms);
}

TEST_F(LeastAgeTest, AForgedFutureMakesNothingOld) {
  for (const Duration ahead : {300 * ms, 1500 * ms, 3000 * ms, 3'600'000 * ms}) {
    (void)age(-ahead);
    EXPECT_EQ(age(2 * ms), 0 * ms);
    EXPECT_EQ(age(302 * ms), 300 * ms);
  }
}

TEST_F(LeastAgeTest, AFutureCountsWhenNothingElseIsSaidForASecond) {
  const Time begin = now;
  for (; now - begin < 1000 * ms; now += 50 * ms) EXPECT_EQ(age(-500 * ms), 0 * ms);
  (void)age(-500 * ms);
  EXPECT_EQ(age(2 * ms), 502 * ms);
}

TEST_F(LeastAgeTest, AFutureBesideHealthyTrafficNeverCounts) {
  for (int i = 0; i < 100; ++i, now += 50 * ms) {
    (void)age(-500 * ms);
    EXPECT_EQ(age(2 * ms), 0 * ms);
  }
}

TEST_F(LeastAgeTest, ThreeOfOneBurstCountOnce) {
  for (int i = 0; i < 30; ++i) (void)age(-500 * ms);
  EXPECT_EQ(age(2 * ms), 0 * ms);
}

TEST_F(LeastAgeTest, AFutureThatWasConfirmedIsForgottenWithinTwoSeconds) {
  for (int i = 0; i < 12; ++i, now += 100 * ms) (void)age(-3000 * ms);
  EXPECT_EQ(age(2 * ms), 3002 * ms);
  EXPECT_LE(poisoned_for(250 * ms), 1600 * ms);
  EXPECT_EQ(age(2 * ms), 0 * ms);
}

TEST_F(LeastAgeTest, AFirstArrivalThatIsForgedEndsWithTheNextThree) {
  LeastAge fresh{std::chrono::seconds(30)};
  (void)fresh.age(now + 500 * ms - difference, now);
  for (int i = 0; i < 3; ++i, now += 50 * ms) {
    EXPECT_EQ(fresh.age(now - difference, now), 500 * ms);
  }
  EXPECT_EQ(fresh.age(now - difference, now), 0 * ms);
}

TEST_F(LeastAgeTest, ALeastAgeThatIsLearnedInAQueueIsDoubtedAtOnce) {
  LeastAge fresh{std::chrono::seconds(30)};
  const Time begin = now;
  const auto age_of = [&](Duration real) { return fresh.age(now - real - difference, now); };
  EXPECT_EQ(age_of(800 * ms), 0 * ms) << "there is no other";
  now += 50 * ms;
  (void)age_of(300 * ms);
  EXPECT_EQ(age_of(800 * ms), 500 * ms);
  for (; now - begin < 2000 * ms; now += 50 * ms) EXPECT_EQ(age_of(790 * ms), 490 * ms);
  EXPECT_EQ(age_of(800 * ms), 10 * ms) << "a hint that nothing confirms may be forged";
}

TEST_F(LeastAgeTest, AQueueStaysOldForAsLongAsTheLinkWasHealthyBefore) {
  for (int i = 0; i < 100; ++i, now += 100 * ms) (void)age(2 * ms);
  for (int i = 0; i < 100; ++i, now += 100 * ms) EXPECT_EQ(age(1002 * ms), 1000 * ms);
}

TEST_F(LeastAgeTest, AForgedPastChangesNothing) {
  for (int i = 0; i < 100; ++i) (void)age(std::chrono::hours(1));
  EXPECT_EQ(age(2 * ms), 0 * ms);
}

TEST_F(LeastAgeTest, AQueueThatDrainsStaysOld) {
  for (Duration real = 1900 * ms; real > 300 * ms; real -= 80 * ms, now += 100 * ms) {
    EXPECT_EQ(age(real), real - 2 * ms);
  }
}

TEST_F(LeastAgeTest, ABurstAfterAnOutageStaysOld) {
  now += std::chrono::minutes(2);
  for (int i = 0; i < 40; ++i, now += ms) EXPECT_GT(age(10'000 * ms), 9000 * ms);
}

TEST_F(LeastAgeTest, OneHealthyArrivalBreaksTheRow) {
  for (int i = 0; i < 100; ++i, now += 100 * ms) {
    EXPECT_EQ(age(1002 * ms), 1000 * ms);
    if (i % 10 == 0) {
      EXPECT_EQ(age(2 * ms), 0 * ms);
    }
  }
}

}  // namespace
}  // namespace tocsin::router
