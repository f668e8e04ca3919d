// SPDX-License-Identifier: Apache-2.0
#include "held_arrivals.hpp"

#include <gmock/gmock.h>

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Time begin{std::chrono::hours(1)};
constexpr FlowId flow = 5;
constexpr FlowId other = 6;

link_event::LinkSample sample(FlowId of, std::uint64_t number) {
  link_event::LinkSample sample{};
  sample.flow = of;
  sample.number = number;
  return sample;
}

class HeldArrivalsTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::uint64_t> taken(double after_s) {
    std::vector<std::uint64_t> numbers;
    for (const auto& one : sut_.take(begin + seconds(after_s))) numbers.push_back(one.number);
    return numbers;
  }
  HeldArrivals sut_;
};

TEST_F(HeldArrivalsTest, HoldsUntilReadersAreThereAndDeliversInOrder) {
  sut_.expect(flow, begin);
  EXPECT_TRUE(sut_.hold(sample(flow, 1)));
  sut_.on_reader(flow, begin + seconds(0.1));
  EXPECT_TRUE(sut_.hold(sample(flow, 2)));
  EXPECT_THAT(taken(0.25), IsEmpty());
  EXPECT_EQ(sut_.deadline(), begin + seconds(0.3));
  EXPECT_TRUE(sut_.hold(sample(flow, 3))) << "behind what is held";
  EXPECT_THAT(taken(0.3), ElementsAre(1, 2, 3));
  EXPECT_FALSE(sut_.hold(sample(flow, 4)));
  EXPECT_EQ(sut_.deadline(), never);
}

TEST_F(HeldArrivalsTest, WhatIsBeyondSixtyFourOfAFlowIsLeftOut) {
  sut_.expect(flow, begin);
  sut_.expect(other, begin);
  for (std::uint64_t number = 1; number <= 65; ++number) {
    EXPECT_TRUE(sut_.hold(sample(flow, number)));
  }
  EXPECT_TRUE(sut_.hold(sample(other, 1)));
  EXPECT_EQ(sut_.take(begin + seconds(2)).size(), 65U) << "64 of one, 1 of the other";
}

TEST_F(HeldArrivalsTest, AFlowThatIsGoneTakesItsSamplesWithIt) {
  sut_.expect(flow, begin);
  EXPECT_TRUE(sut_.hold(sample(flow, 1)));
  sut_.forget(flow);
  EXPECT_THAT(taken(3), IsEmpty());
  EXPECT_FALSE(sut_.hold(sample(flow, 2)));
}

}  // namespace
}  // namespace tocsin
