// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sequence_set.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <random>
#include <set>
#include <vector>

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(SequenceSet, ClosesTheLowestGaps) {
  SequenceSet sut;
  for (const std::uint64_t one : {1, 3, 5, 7}) sut.insert(one);
  sut.close_gaps(2);
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(1, 5), Pair(7, 7)));
}

TEST(SequenceSet, TakesTheLargestNumber) {
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
  SequenceSet sut;
  sut.insert(largest);
  sut.insert(largest - 1);
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(largest - 1, largest)));
}

TEST(SequenceSet, IsASetOfNumbersWhateverComes) {
  std::mt19937 random(7);
  SequenceSet sut;
  std::set<std::uint64_t> expected;
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t first = random() % 200;
    const std::uint64_t last = first + (random() % 20 == 0 ? random() % 6 : 0);
    if (first == last) {
      EXPECT_EQ(sut.insert(first), expected.count(first) == 0);
    } else {
      sut.insert(first, last);
    }
    for (std::uint64_t one = first; one <= last; ++one) expected.insert(one);
    if (i % 300 == 299) sut = {}, expected.clear();
    for (std::uint64_t one = 0; one < 210; ++one) {
      ASSERT_EQ(sut.contains(one), expected.count(one) != 0) << one << " in step " << i;
    }
  }
}

}  // namespace
}  // namespace tocsin::sample_log
