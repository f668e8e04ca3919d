// SPDX-License-Identifier: Apache-2.0
#include "report/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace tocsin::report {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Arrival arrival(double sent_s, double received_s, std::uint64_t sequence = 1,
                const std::string& writer = "w", const std::string& topic = "t") {
  return {sent_s, received_s, topic, writer, sequence, 100};
}

std::uint64_t lost(const std::vector<Arrival>& live) { return fates_of(live).lost; }

TEST(Percentile, IsANearestRank) {
  EXPECT_EQ(percentile({4, 1, 3, 2}, 0.5), 2);
  EXPECT_EQ(percentile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(percentile({4, 1, 3, 2}, 1.0), 4);
  EXPECT_EQ(percentile({7}, 0.01), 7);
}

TEST(Percentile, IsTheValueThatOnePercentExceed) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  EXPECT_EQ(percentile(values, 0.99), 99);
  values.push_back(101);
  EXPECT_EQ(percentile(values, 0.99), 100);
}

TEST(Percentile, IsNanWithoutValues) { EXPECT_TRUE(std::isnan(percentile({}, 0.5))); }

TEST(Lost, CountsGapsInTheSequence) {
  EXPECT_EQ(lost({arrival(0, 0, 5), arrival(0, 0, 6), arrival(0, 0, 9)}), 2U);
  EXPECT_EQ(lost({arrival(0, 0, 5), arrival(0, 0, 6)}), 0U);
  EXPECT_EQ(lost({}), 0U);
}

TEST(Lost, TakesSamplesInAnyOrder) {
  EXPECT_EQ(lost({arrival(0, 0, 3), arrival(0, 0, 1), arrival(0, 0, 2)}), 0U);
}

TEST(Lost, StartsAnewWithEachWriter) {
  EXPECT_EQ(lost({arrival(0, 0, 90, "before"), arrival(0, 0, 1, "after")}), 0U);
}

TEST(Lost, KeepsTopicsApart) {
  EXPECT_EQ(
      lost({arrival(0, 0, 1, "w", "a"), arrival(0, 0, 3, "w", "a"), arrival(0, 0, 2, "w", "b")}),
      1U);
}

TEST(Lost, IsNotWhatWasFilledIn) {
  const std::vector<Arrival> live{arrival(0, 0, 1), arrival(0, 0, 5)};
  const Fates sut = fates_of(live, {arrival(0, 9, 2), arrival(0, 9, 3)});
  EXPECT_EQ(sut.backfilled, 2U);
  EXPECT_EQ(sut.lost, 1U) << "number 4";
}

TEST(Lost, CountsWhatCameLiveAndWasFilledInOnce) {
  const Fates sut = fates_of({arrival(0, 0, 1), arrival(0, 0, 2)}, {arrival(0, 9, 2)});
  EXPECT_EQ(sut.backfilled, 0U);
  EXPECT_EQ(sut.lost, 0U);
}

TEST(Lost, ReachesToTheFirstAndLastThatWereFilledIn) {
  const Fates sut = fates_of({arrival(0, 0, 5)}, {arrival(0, 9, 3), arrival(0, 9, 8)});
  EXPECT_EQ(sut.backfilled, 2U);
  EXPECT_EQ(sut.lost, 3U) << "4, 6 and 7";
}

TEST(Lost, OfAWriterIsNotFilledInByAnother) {
  const Fates sut =
      fates_of({arrival(0, 0, 1, "a"), arrival(0, 0, 3, "a")}, {arrival(0, 9, 2, "b")});
  EXPECT_EQ(sut.lost, 1U);
}

TEST(Ages, GrowUntilTheNextArrival) {
  const auto sut = ages({arrival(10.0, 10.5), arrival(12.0, 12.25)}, 12.5, 0.5);
  EXPECT_THAT(sut, ElementsAre(DoubleNear(0.5, 1e-9), DoubleNear(1.0, 1e-9), DoubleNear(1.5, 1e-9),
                               DoubleNear(2.0, 1e-9), DoubleNear(0.5, 1e-9)));
}

TEST(Ages, IgnoreASampleThatWasOvertaken) {
  const auto sut = ages({arrival(11, 11), arrival(10, 11.1)}, 12, 1);
  EXPECT_THAT(sut, ElementsAre(DoubleNear(0, 1e-9), DoubleNear(1, 1e-9)));
}

TEST(Ages, AreNoneWithoutArrivals) { EXPECT_THAT(ages({}, 5, 1), IsEmpty()); }

TEST(ByteRates, SumTheBytesOfEachSecond) {
  EXPECT_THAT(byte_rates({arrival(0, 10.0), arrival(0, 10.9), arrival(0, 11.0)}, 10, 12.5),
              ElementsAre(200, 100, 0));
}

TEST(ByteRates, LeaveOutWhatIsOutside) {
  EXPECT_THAT(byte_rates({arrival(0, 9.9), arrival(0, 12)}, 10, 12), ElementsAre(0, 0));
  EXPECT_THAT(byte_rates({arrival(0, 9.9)}, 10, 10), IsEmpty());
}

constexpr double born_s = 1.0;         // the clock of a computer without a battery
constexpr double corrected_s = 1.8e9;  // after NTP

TEST(Ages, AClockThatIsSetByYearsCostsNoMemory) {
  const auto sut =
      ages({arrival(born_s, born_s), arrival(corrected_s, corrected_s)}, corrected_s + 100, 0.1);
  EXPECT_LE(sut.size(), 1'000'001U);
  EXPECT_EQ(sut.front(), 0);
  EXPECT_LT(sut.back(), 3600) << "of the newest one";
}

TEST(Ages, TimesThatAreNoneHaveNoAge) {
  EXPECT_THAT(ages({arrival(-1e308, -1e308)}, 1e308, 0.1), IsEmpty());
}

TEST(ByteRates, AClockThatIsSetByYearsCostsNoMemory) {
  const auto sut = byte_rates({arrival(born_s, born_s), arrival(corrected_s, corrected_s)}, born_s,
                              corrected_s + 1);
  EXPECT_LE(sut.size(), 100'000U);
  const double bin_s = rate_bin_s(born_s, corrected_s + 1);
  EXPECT_NEAR(std::accumulate(sut.begin(), sut.end(), 0.0) * bin_s, 200, 1e-6) << "no byte is lost";
}

TEST(ByteRates, BinsAreSecondsForMoreThanADay) {
  EXPECT_EQ(rate_bin_s(0, 1e5), 1);
  EXPECT_EQ(rate_bin_s(0, 1e5 + 1), 2);
}

/// Samples of one writer, sent each second; some are lost, some late, some overtake others.
std::vector<Arrival> random_arrivals(unsigned seed) {
  std::minstd_rand random(seed);
  std::vector<Arrival> arrivals;
  for (std::uint64_t i = 1; i <= 60; ++i) {
    const double sent_s = 1000 + static_cast<double>(i);
    const double late_s = static_cast<double>(random() % 4000) / 1000;
    if (random() % 4 != 0) arrivals.push_back(arrival(sent_s, sent_s + late_s, i));
  }
  std::shuffle(arrivals.begin(), arrivals.end(), random);
  return arrivals;
}

TEST(Ages, AreThoseThatLookingAtEveryArrivalGives) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto arrivals = random_arrivals(seed);
    const auto earliest = std::min_element(
        arrivals.begin(), arrivals.end(),
        [](const Arrival& a, const Arrival& b) { return a.received_s < b.received_s; });
    const auto sut = ages(arrivals, 1070, 0.5);
    for (std::size_t i = 0; i < sut.size(); ++i) {
      const double now_s = earliest->received_s + 0.5 * static_cast<double>(i);
      double newest_s = 0;
      for (const Arrival& one : arrivals) {
        if (one.received_s <= now_s) newest_s = std::max(newest_s, one.sent_s);
      }
      ASSERT_NEAR(sut[i], now_s - newest_s, 1e-9) << seed;
    }
  }
}

TEST(Lost, IsWhatIsMissingBetweenTheFirstAndTheLastInAnyOrder) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto arrivals = random_arrivals(seed);
    std::uint64_t first = 1000;
    std::uint64_t last = 0;
    for (const Arrival& one : arrivals) {
      first = std::min(first, one.sequence);
      last = std::max(last, one.sequence);
    }
    ASSERT_EQ(lost(arrivals), last - first + 1 - arrivals.size()) << seed;
  }
}

TEST(Lost, ASampleThatCameTwiceHidesNoneOfAnotherWriter) {
  EXPECT_EQ(
      lost({arrival(0, 0, 1), arrival(0, 0, 1), arrival(0, 0, 4, "x"), arrival(0, 0, 6, "x")}), 1U);
}

TEST(Percentile, IsTheSameAsInASortedList) {
  std::minstd_rand random(3);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> values(1 + random() % 50);
    for (double& value : values) value = static_cast<double>(random() % 100);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double share = static_cast<double>(1 + random() % 100) / 100;
    const double found = percentile(values, share);
    const auto below = std::upper_bound(sorted.begin(), sorted.end(), found) - sorted.begin();
    ASSERT_GE(static_cast<double>(below), share * static_cast<double>(values.size()) - 1e-9);
  }
}

}  // namespace
}  // namespace tocsin::report
