// SPDX-License-Identifier: Apache-2.0
#include "runtime/detail/sample_queue.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

Sample numbered(std::uint64_t sequence) {
  Sample sample;
  sample.sequence = sequence;
  sample.message = std::make_shared<const std::uint64_t>(sequence);
  return sample;
}

TEST(SampleQueue, GivesSamplesInTheOrderOfArrival) {
  SampleQueue sut(8);
  for (std::uint64_t i = 1; i <= 5; ++i) EXPECT_TRUE(sut.push(numbered(i)));
  for (std::uint64_t i = 1; i <= 5; ++i) EXPECT_EQ(sut.pop().sequence, i);
  EXPECT_EQ(sut.size(), 0U);
}

TEST(SampleQueue, KeepsTheOrderWhenItGrowsInTheMiddleOfTheRing) {
  SampleQueue sut(8);
  EXPECT_TRUE(sut.push(numbered(1)));
  EXPECT_TRUE(sut.push(numbered(2)));
  EXPECT_EQ(sut.pop().sequence, 1U);
  for (std::uint64_t i = 3; i <= 9; ++i) EXPECT_TRUE(sut.push(numbered(i)));
  for (std::uint64_t i = 2; i <= 9; ++i) EXPECT_EQ(sut.pop().sequence, i);
}

TEST(SampleQueue, IsFullOnlyAtItsCapacityAndThenDropsTheOldest) {
  SampleQueue sut(4);
  for (std::uint64_t i = 1; i <= 4; ++i) EXPECT_TRUE(sut.push(numbered(i)));
  EXPECT_FALSE(sut.push(numbered(5)));
  EXPECT_EQ(sut.size(), 4U);
  EXPECT_EQ(sut.pop().sequence, 2U);
}

TEST(SampleQueue, HoldsNoMessageThatWasTakenDroppedOrCleared) {
  SampleQueue sut(1);
  const Sample first = numbered(1);
  EXPECT_TRUE(sut.push(Sample(first)));
  EXPECT_FALSE(sut.push(numbered(2)));
  EXPECT_EQ(first.message.use_count(), 1);
  EXPECT_EQ(sut.pop().sequence, 2U);
  EXPECT_TRUE(sut.push(Sample(first)));
  sut.clear();
  EXPECT_EQ(first.message.use_count(), 1);
  EXPECT_EQ(sut.size(), 0U);
}

}  // namespace
}  // namespace tocsin
