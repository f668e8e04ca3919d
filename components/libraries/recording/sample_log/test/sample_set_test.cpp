// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sample_set.hpp"

#include <gtest/gtest.h>

namespace tocsin::sample_log {
namespace {

TEST(SampleSet, TellsStreamsAndWritersApart) {
  SampleSet sut;
  EXPECT_TRUE(sut.add({1, 2, 3}));
  EXPECT_FALSE(sut.add({1, 2, 3}));
  EXPECT_TRUE(sut.contains({1, 2, 3}));
  EXPECT_FALSE(sut.contains({1, 2, 4}));
  EXPECT_FALSE(sut.contains({1, 3, 3}));
  EXPECT_FALSE(sut.contains({2, 2, 3}));
}

TEST(SampleSet, ForgetsTheWriterThatWasUnheardOfForLongest) {
  SampleSet sut;
  for (std::uint64_t source = 0; source < 4096; ++source) sut.add({1, source, 1});
  sut.add({1, 0, 2});
  sut.add({1, 5000, 1});
  EXPECT_TRUE(sut.contains({1, 0, 1})) << "was heard of again";
  EXPECT_FALSE(sut.contains({1, 1, 1}));
  EXPECT_TRUE(sut.contains({1, 2, 1}));
  EXPECT_TRUE(sut.contains({1, 5000, 1}));
}

TEST(SampleSet, BeyondItsGapsTheLowestCountsAsClosed) {
  SampleSet sut;
  for (std::uint64_t i = 0; i <= 4096; ++i) sut.add({1, 2, 10 * i});
  EXPECT_TRUE(sut.contains({1, 2, 5})) << "the lowest gap";
  EXPECT_FALSE(sut.contains({1, 2, 15}));
}

}  // namespace
}  // namespace tocsin::sample_log
