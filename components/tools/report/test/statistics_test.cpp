// SPDX-License-Identifier: Apache-2.0
#include "report/statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace tocsin::report {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Arrival arrival(double sent_s, double received_s, std::uint64_t sequence = 1,
                const std::string& writer = "w", const std::string& topic = "t") {
  return {sent_s, received_s, topic, writer, sequence, 100};
}

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

}  // namespace
}  // namespace tocsin::report
