// SPDX-License-Identifier: Apache-2.0
#include "link_router/source_memory.hpp"

#include <gtest/gtest.h>

namespace tocsin::router {
namespace {

using Verdict = SourceMemory::Verdict;
constexpr Duration ms = std::chrono::milliseconds(1);
constexpr std::uint64_t forged = ~std::uint64_t{0};

class SourceMemoryTest : public ::testing::Test {
 protected:
  /// As a receiver does.
  Verdict receive(std::uint64_t sequence, bool fresh = true) {
    const Verdict verdict = sut.judge(sequence, depth, fresh, now);
    if (verdict == Verdict::newer) sut.add(sequence, depth, now);
    return verdict;
  }
  std::size_t depth = 1;
  SourceMemory sut;
  Time now{std::chrono::hours(1)};
};

TEST_F(SourceMemoryTest, OfDepthOneEachNumberOnceAndInOrder) {
  EXPECT_EQ(receive(5), Verdict::newer);
  EXPECT_EQ(receive(5), Verdict::duplicate);
  EXPECT_EQ(receive(4), Verdict::superseded);
  EXPECT_EQ(receive(6), Verdict::newer);
}

TEST_F(SourceMemoryTest, DeeperOnesTakeARepairedNumberLate) {
  depth = 2;
  EXPECT_EQ(receive(1), Verdict::newer);
  EXPECT_EQ(receive(4), Verdict::newer);
  EXPECT_EQ(receive(3), Verdict::newer);
  EXPECT_EQ(receive(2), Verdict::superseded);
}

TEST_F(SourceMemoryTest, AForgedNumberIsForgottenWhenTheSourceGoesOn) {
  EXPECT_EQ(receive(10), Verdict::newer);
  EXPECT_EQ(receive(forged), Verdict::newer);
  const Time begin = now;
  std::uint64_t sequence = 11;
  while (receive(sequence) != Verdict::newer) {
    ++sequence;
    now += 200 * ms;
    ASSERT_LT(now - begin, 2000 * ms);
  }
  EXPECT_EQ(now - begin, SourceMemory::contrary_for);
  EXPECT_EQ(receive(sequence), Verdict::duplicate);
  EXPECT_EQ(receive(sequence - 1), Verdict::superseded);
  EXPECT_EQ(receive(sequence + 1), Verdict::newer);
}

TEST_F(SourceMemoryTest, WhatWasDeliveredBeforeIsNotDeliveredAgain) {
  depth = 3;
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) (void)receive(sequence);
  for (std::uint64_t sequence = forged - 3; sequence < forged; ++sequence) (void)receive(sequence);
  (void)receive(4);
  now += SourceMemory::contrary_for;
  EXPECT_EQ(receive(5), Verdict::newer);
  EXPECT_EQ(receive(3), Verdict::superseded);
}

TEST_F(SourceMemoryTest, RepetitionsAndReplaysAreNotContrary) {
  (void)receive(100);
  for (int i = 0; i < 20; ++i, now += 200 * ms) {
    EXPECT_EQ(receive(50), Verdict::superseded) << "one sample again and again";
  }
  for (std::uint64_t sequence = 60; sequence < 80; ++sequence, now += 200 * ms) {
    EXPECT_EQ(receive(sequence, false), Verdict::superseded) << "sent long ago";
  }
}

TEST_F(SourceMemoryTest, LateRepairsBetweenNewerOnesAreNotContrary) {
  for (std::uint64_t sequence = 100; sequence < 140; ++sequence, now += 100 * ms) {
    EXPECT_EQ(receive(sequence), Verdict::newer);
    EXPECT_EQ(receive(sequence - 50), Verdict::superseded);
  }
}

}  // namespace
}  // namespace tocsin::router
