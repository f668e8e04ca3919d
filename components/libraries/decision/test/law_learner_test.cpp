// SPDX-License-Identifier: Apache-2.0
#include "decision/law_learner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ar1_feed.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

/// Feeds an AR(1) link of that law.
void feed(LawLearner& sut, Normal law, double correlation, int samples, unsigned seed = 1) {
  Ar1Feed link(correlation, seed);
  for (int i = 0; i < samples; ++i) sut.add(link.next(law));
}

TEST(LawLearner, StaysWithTheLawThatIsRight) {
  LawLearner sut(thesis_good);
  feed(sut, thesis_good, 0, 10000);
  EXPECT_NEAR(sut.law().mean, thesis_good.mean, 0.7);
  EXPECT_NEAR(sut.law().sd, thesis_good.sd, 0.7);
  EXPECT_LT(std::abs(sut.evidence()), 3);
}

TEST(LawLearner, FindsTheLawOfASiteThatIsOtherThanConfigured) {
  LawLearner sut(thesis_good);
  feed(sut, {74, 7}, 0.5, 15000);
  EXPECT_NEAR(sut.law().mean, 74, 1);
  EXPECT_NEAR(sut.law().sd, 7, 0.7);
  EXPECT_LT(sut.evidence(), -10);
  EXPECT_LT(sut.spread_evidence(), -5);
}

TEST(LawLearner, IsNotFasterThanAFault) {
  LawLearner sut(thesis_good);
  feed(sut, thesis_good, 0, 5000);
  const Normal before = sut.law();
  for (int i = 0; i < 60; ++i) sut.add(0);
  EXPECT_LT(before.mean - sut.law().mean, 1.74 * 60 / 1800 * before.sd * 1.05);
  EXPECT_LT(sut.law().sd / before.sd, 1.06);
}

TEST(LawLearner, StaysWithinItsLimitsWhateverComes) {
  LawLearner sut(thesis_good);
  for (int i = 0; i < 100000; ++i) sut.add(i % 2 == 0 ? 0 : 5);
  EXPECT_DOUBLE_EQ(sut.law().mean, thesis_good.mean - 2 * thesis_good.sd);
  EXPECT_LE(sut.law().sd, 2 * thesis_good.sd);
  LawLearner constant(thesis_good);
  for (int i = 0; i < 100000; ++i) constant.add(81);
  EXPECT_DOUBLE_EQ(constant.law().sd, thesis_good.sd / 2);
  constant.add(1e300);
  EXPECT_TRUE(std::isfinite(constant.law().mean));
}

TEST(LawLearner, IsHardlyMovedByGlitches) {
  LawLearner sut(thesis_good);
  std::mt19937_64 random(3);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> normal(thesis_good.mean, thesis_good.sd);
  for (int i = 0; i < 20000; ++i) sut.add(i % 20 == 0 ? 10 : normal(random));
  EXPECT_NEAR(sut.law().mean, thesis_good.mean, 1.5);  // the plain mean is 3.6 lower
  EXPECT_NEAR(sut.law().sd, thesis_good.sd, 1.6);      // the plain spread is 18
}

TEST(LawLearner, CountsCorrelatedSamplesForLess) {
  LawLearner independent(thesis_good);
  LawLearner correlated(thesis_good);
  feed(independent, thesis_good, 0, 5000);
  feed(correlated, thesis_good, 0.9, 5000);
  EXPECT_NEAR(independent.effective_samples(), 3600, 700);
  EXPECT_LT(correlated.effective_samples(), 500);
  EXPECT_GT(correlated.effective_samples(), 80);
}

TEST(LawLearner, SeldomHasEvidenceAgainstTheRightLawOfACorrelatedLink) {
  for (const double correlation : {0.0, 0.5, 0.9}) {
    int wrong = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
      LawLearner sut(thesis_good);
      feed(sut, thesis_good, correlation, 6000, seed);
      wrong += std::abs(sut.evidence()) > 3;
      wrong += std::abs(sut.spread_evidence()) > 3;
    }
    EXPECT_LE(wrong, 6) << correlation;  // 0.3 % of 200 were all exact
  }
}

TEST(LawLearner, SaysNothingBeforeTenSamplesAndIgnoresNan) {
  LawLearner sut(thesis_good);
  for (int i = 0; i < 4; ++i) sut.add(20);
  EXPECT_EQ(sut.evidence(), 0);
  EXPECT_EQ(sut.spread_evidence(), 0);
  const Normal before = sut.law();
  sut.add(NAN);
  EXPECT_EQ(sut.law().mean, before.mean);
}

TEST(LawLearner, RejectsLimitsThatAreNone) {
  EXPECT_THROW(LawLearner({80, 0}), ConfigError);
  EXPECT_THROW(LawLearner(thesis_good, {0, 2, 2}), ConfigError);
  EXPECT_THROW(LawLearner(thesis_good, {100, 2, 0.5}), ConfigError);
}

}  // namespace
}  // namespace tocsin::decision
