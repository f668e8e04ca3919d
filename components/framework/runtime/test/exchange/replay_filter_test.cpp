// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/replay_filter.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace tocsin {
namespace {

TEST(ReplayFilter, LetsEachNumberOfAWriterPassOnce) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 10));
  EXPECT_FALSE(sut.is_first(1, 10));
  EXPECT_TRUE(sut.is_first(1, 11));
  EXPECT_FALSE(sut.is_first(1, 10));
}

TEST(ReplayFilter, KnowsWritersApart) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 10));
  EXPECT_TRUE(sut.is_first(2, 10));
}

TEST(ReplayFilter, LetsALateOnePassThatHadNotCome) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 10));
  EXPECT_TRUE(sut.is_first(1, 13));
  EXPECT_TRUE(sut.is_first(1, 12));
  EXPECT_FALSE(sut.is_first(1, 12));
}

TEST(ReplayFilter, TakesWhatIsOlderThanItsMemoryForSeen) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 100));
  EXPECT_TRUE(sut.is_first(1, 37));
  EXPECT_FALSE(sut.is_first(1, 36));
}

TEST(ReplayFilter, AJumpBeyondItsMemoryForgetsAllBefore) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 1));
  EXPECT_TRUE(sut.is_first(1, 65));
  EXPECT_TRUE(sut.is_first(1, 1ULL << 40U));
  EXPECT_FALSE(sut.is_first(1, 65));
  EXPECT_TRUE(sut.is_first(1, (1ULL << 40U) - 63));
}

TEST(ReplayFilter, AForgottenWriterBeginsAnew) {
  ReplayFilter sut;
  EXPECT_TRUE(sut.is_first(1, 10));
  sut.forget(1);
  EXPECT_TRUE(sut.is_first(1, 10));
}

TEST(ReplayFilter, NeverLetsANumberPassTwice) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  ReplayFilter sut;
  std::set<std::uint64_t> passed;
  std::uint64_t at = 1000;
  for (int i = 0; i < 20000; ++i) {
    at += random() % 3;
    const std::uint64_t sequence = at - random() % 80;
    if (sut.is_first(7, sequence)) {
      EXPECT_TRUE(passed.insert(sequence).second) << sequence;
    }
  }
  EXPECT_GT(passed.size(), 10000U);
}

}  // namespace
}  // namespace tocsin
