// SPDX-License-Identifier: Apache-2.0
#include "page/inference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tocsin::experiment {
namespace {

const double none = std::nan("");

TEST(TQuantile, AgreesWithTheTables) {
  EXPECT_NEAR(t_quantile_975(1), 12.7062, 1e-4);
  EXPECT_NEAR(t_quantile_975(4), 2.77645, 1e-5);
  EXPECT_NEAR(t_quantile_975(5), 2.57058, 1e-5);
  EXPECT_NEAR(t_quantile_975(10), 2.22814, 1e-5);
  EXPECT_NEAR(t_quantile_975(30), 2.04227, 1e-5);
  EXPECT_NEAR(t_quantile_975(1000), 1.96234, 1e-5);
}

TEST(Estimate, HasMeanAndInterval) {
  const Estimate sut = estimate({1, 2, 3, 4, 5});
  EXPECT_EQ(sut.mean, 3);
  EXPECT_EQ(sut.runs, 5);
  EXPECT_NEAR(sut.high - sut.mean, 2.77645 * std::sqrt(2.5 / 5), 1e-4);
  EXPECT_NEAR(sut.mean - sut.low, sut.high - sut.mean, 1e-12);
}

TEST(Estimate, LeavesOutRunsWithoutAnAnswer) {
  const Estimate sut = estimate({1, none, 3});
  EXPECT_EQ(sut.mean, 2);
  EXPECT_EQ(sut.runs, 2);
}

TEST(Estimate, HasNoIntervalOfOneRunAndNoMeanOfNone) {
  EXPECT_EQ(estimate({7}).mean, 7);
  EXPECT_TRUE(std::isnan(estimate({7}).low));
  EXPECT_TRUE(std::isnan(estimate({none}).mean));
  EXPECT_EQ(estimate({}).runs, 0);
}

TEST(Estimate, IsBelowOrAboveOnlyWithItsWholeInterval) {
  EXPECT_TRUE((Estimate{-2, -3, -1, 5}.below(0)));
  EXPECT_FALSE((Estimate{-2, -5, 1, 5}.below(0)));
  EXPECT_TRUE((Estimate{2, 1, 3, 5}.above(0)));
  EXPECT_FALSE((Estimate{7, none, none, 1}.above(0)));
}

TEST(PairedDifference, NeedsBothOfAPair) {
  const Estimate sut = paired_difference({5, none, 9, 4}, {3, 1, none, 1});
  EXPECT_EQ(sut.runs, 2);
  EXPECT_EQ(sut.mean, 2.5);
}

TEST(PairedDifference, IsSharperThanTheRunsThemselves) {
  const Estimate sut = paired_difference({101, 201, 301.1}, {100, 200, 300});
  EXPECT_TRUE(sut.above(0.5));
}

TEST(Estimate, CoversTheTruthInNinetyFiveOfAHundredCases) {
  std::mt19937 random(7);
  std::normal_distribution<double> law(10, 3);
  int covered = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> values(8);
    for (double& one : values) one = law(random);
    const Estimate sut = estimate(values);
    covered += sut.low <= 10 && 10 <= sut.high ? 1 : 0;
  }
  EXPECT_NEAR(covered / 2000.0, 0.95, 0.015);
}

TEST(Estimate, OfEqualRunsHasNoWidth) {
  const Estimate sut = estimate({4, 4, 4});
  EXPECT_EQ(sut.mean, 4);
  EXPECT_EQ(sut.low, 4);
  EXPECT_EQ(sut.high, 4);
}

TEST(Estimate, IsStudentsIntervalByHand) {
  // Mean 2, variance 1, three runs: 2 +- 4.30265 / sqrt(3).
  const Estimate sut = estimate({1, 2, 3});
  EXPECT_NEAR(sut.high - sut.mean, 4.30265 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(sut.mean - sut.low, 4.30265 / std::sqrt(3.0), 1e-5);
}

TEST(Estimate, LeavesOutTheInfinite) {
  EXPECT_EQ(estimate({1, HUGE_VAL, 3}).mean, 2);
  EXPECT_EQ(estimate({1, HUGE_VAL, 3}).runs, 2);
}

TEST(PairedDifference, OfNoPairIsNoAnswer) {
  const Estimate sut = paired_difference({NAN, 1}, {1, NAN});
  EXPECT_EQ(sut.runs, 0);
  EXPECT_TRUE(std::isnan(sut.mean));
}

TEST(PairedDifference, IsTheFirstMinusTheSecond) {
  EXPECT_EQ(paired_difference({5, 6}, {1, 2}).mean, 4);
}

TEST(EstimateOverGroups, TakesEachGroupForOneValue) {
  // means 2 and 5; over single values the interval would be narrower
  const std::vector<double> values{1, 3, 2, 5, 5, 5};
  const std::vector<int> group{1, 1, 1, 2, 2, 2};
  const Estimate sut = estimate_over_groups(values, group);
  EXPECT_DOUBLE_EQ(sut.mean, 3.5);
  EXPECT_EQ(sut.runs, 2);
  EXPECT_NEAR(sut.high - sut.mean, 12.706 * 1.5, 1e-2);  // t of one degree, 3 / 2
  EXPECT_LT(estimate(values).high, sut.high);
}

TEST(EstimateOverGroups, WeighsGroupsAlikeAndLeavesOutThoseWithoutAnswer) {
  const Estimate sut = estimate_over_groups({1, 1, 1, 1, 3, NAN}, {1, 1, 1, 1, 2, 3});
  EXPECT_DOUBLE_EQ(sut.mean, 2);
  EXPECT_EQ(sut.runs, 2);
}

}  // namespace
}  // namespace tocsin::experiment
