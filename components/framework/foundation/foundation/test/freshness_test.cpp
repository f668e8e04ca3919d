// SPDX-License-Identifier: Apache-2.0
#include "foundation/freshness.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

constexpr Duration tick{1};

TEST(Freshness, AValueIsFreshThenStaleThenUnknown) {
  const FreshnessLimits limits{3, 30};
  EXPECT_EQ(freshness(Duration{0}, limits), Freshness::fresh);
  EXPECT_EQ(freshness(seconds(3), limits), Freshness::fresh);
  EXPECT_EQ(freshness(seconds(3) + tick, limits), Freshness::stale);
  EXPECT_EQ(freshness(seconds(30), limits), Freshness::stale);
  EXPECT_EQ(freshness(seconds(30) + tick, limits), Freshness::unknown);
}

TEST(Freshness, WhatWasNeverHeardIsUnknown) {
  EXPECT_EQ(freshness(std::nullopt, FreshnessLimits{}), Freshness::unknown);
}

TEST(Freshness, AValueFromTheFutureIsFresh) {
  EXPECT_EQ(freshness(seconds(-1), FreshnessLimits{}), Freshness::fresh);
}

TEST(Freshness, WithOneLimitForBothNothingIsStale) {
  const FreshnessLimits limits{5, 5};
  EXPECT_EQ(freshness(seconds(5), limits), Freshness::fresh);
  EXPECT_EQ(freshness(seconds(5) + tick, limits), Freshness::unknown);
}

TEST(AgeText, UsesTheUnitThatKeepsItShort) {
  EXPECT_EQ(age_text(seconds(0.4)), "0 s");
  EXPECT_EQ(age_text(seconds(12.9)), "12 s");
  EXPECT_EQ(age_text(seconds(99.9)), "99 s");
  EXPECT_EQ(age_text(seconds(100)), "1 min");
  EXPECT_EQ(age_text(seconds(99 * 60.0)), "99 min");
  EXPECT_EQ(age_text(seconds(100 * 60.0)), "1 h");
  EXPECT_EQ(age_text(seconds(-5)), "0 s");
}

}  // namespace
}  // namespace tocsin
