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

TEST(SequenceSet, HasOneRangeForWhatComesWithoutGaps) {
  SequenceSet sut;
  for (std::uint64_t i = 5; i <= 9; ++i) EXPECT_TRUE(sut.insert(i));
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(5, 9)));
}

TEST(SequenceSet, TellsWhatIsNew) {
  SequenceSet sut;
  EXPECT_TRUE(sut.insert(3));
  EXPECT_FALSE(sut.insert(3));
  EXPECT_FALSE(sut.contains(2));
  EXPECT_TRUE(sut.contains(3));
  EXPECT_FALSE(sut.contains(4));
}

TEST(SequenceSet, AGapThatIsFilledJoinsItsNeighbours) {
  SequenceSet sut;
  sut.insert(1, 3);
  sut.insert(5, 8);
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(1, 3), Pair(5, 8)));
  sut.insert(4);
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(1, 8)));
}

TEST(SequenceSet, ClosesTheLowestGaps) {
  SequenceSet sut;
  for (const std::uint64_t one : {1, 3, 5, 7}) sut.insert(one);
  sut.close_gaps(2);
  EXPECT_THAT(sut.ranges(), ElementsAre(Pair(1, 5), Pair(7, 7)));
}

TEST(SequenceSet, HasNothingAtFirstAndNothingToClose) {
  SequenceSet sut;
  sut.close_gaps(1);
  EXPECT_TRUE(sut.ranges().empty());
  EXPECT_FALSE(sut.contains(0));
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
