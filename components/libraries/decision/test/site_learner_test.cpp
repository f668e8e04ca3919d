// SPDX-License-Identifier: Apache-2.0
#include "decision/site_learner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ar1_feed.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

PolicyParams learning() {
  PolicyParams params;
  params.laws = "apply";
  params.policy = "tocp_reverse";
  return params;
}

void feed(SiteLearner& sut, const Normal& law, int samples, double correlation = 0.5,
          unsigned seed = 1) {
  Ar1Feed link(correlation, seed);
  for (int i = 0; i < samples; ++i) sut.add(std::clamp(link.next(law), 0.0, 100.0));
}

TEST(SiteLearner, ProposesTheLawOfAnotherBuilding) {
  SiteLearner sut(learning());
  feed(sut, {72, 7}, 10000);
  const LearnedLaw learned = sut.learned();
  EXPECT_TRUE(learned.proposed);
  EXPECT_NEAR(learned.learned.mean, 72, 1);
  EXPECT_NEAR(learned.learned.sd, 7, 1);
  EXPECT_EQ(learned.in_force.mean, thesis_good.mean);
  EXPECT_LT(learned.evidence, -10);
  EXPECT_LT(learned.left_out_share, 0.05);
}

TEST(SiteLearner, SeldomProposesAnythingForTheBuildingThatIsConfigured) {
  for (const double correlation : {0.0, 0.5, 0.9}) {
    int proposed = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
      SiteLearner sut(learning());
      feed(sut, thesis_good, 6000, correlation, seed);
      proposed += sut.learned().proposed;
    }
    EXPECT_LE(proposed, 3) << correlation;
  }
}

TEST(SiteLearner, DoesNotLearnADeadLink) {
  SiteLearner sut(learning());
  feed(sut, thesis_good, 3600);
  const LearnedLaw before = sut.learned();
  feed(sut, thesis_bad, 1800);
  const LearnedLaw after = sut.learned();
  EXPECT_NEAR(after.learned.mean, before.learned.mean, 0.1 * thesis_good.sd);
  EXPECT_NEAR(after.learned.sd, before.learned.sd, 0.1 * thesis_good.sd);
  EXPECT_NEAR(after.left_out_share, 1800 / 5400.0, 0.02);
  EXPECT_FALSE(after.proposed);
}

TEST(SiteLearner, IsMovedByAFaultThatLooksGoodNoFasterThanItsMemoryAllows) {
  SiteLearner sut(learning());
  feed(sut, thesis_good, 3600);
  const double before = sut.learned().learned.mean;
  feed(sut, {60, 5}, 60);  // nearer to good than to bad
  EXPECT_GT(sut.learned().learned.mean, before - 1.74 * 60 / 1800 * thesis_good.sd * 1.1);
  feed(sut, {60, 5}, 100000);  // whatever lasts is the law, within its limit
  EXPECT_NEAR(sut.learned().learned.mean, thesis_good.mean - 2 * thesis_good.sd, 0.5);
}

TEST(SiteLearner, LearnsAgainFromTheFirstGoodSampleAfterAFault) {
  PolicyParams params = learning();
  SiteLearner sut(params);
  for (int i = 0; i < 100; ++i) sut.add(20);
  EXPECT_DOUBLE_EQ(sut.learned().left_out_share, 1);
  sut.add(80);
  EXPECT_DOUBLE_EQ(sut.learned().left_out_share, 100 / 101.0);
}

TEST(SiteLearner, ForgetsItsSuspicionAfterAGap) {
  SiteLearner sut(learning());
  for (int i = 0; i < 10; ++i) sut.add(20);
  sut.add(57.5);  // hardly good: suspicion goes on
  EXPECT_DOUBLE_EQ(sut.learned().left_out_share, 1);
  sut.forget();
  sut.add(57.5);
  EXPECT_DOUBLE_EQ(sut.learned().left_out_share, 11 / 12.0);
}

TEST(SiteLearner, WantsAnotherLawInForceSeldomAndOnlyOnAGoodLink) {
  SiteLearner sut(learning());
  EXPECT_FALSE(sut.due());
  feed(sut, {72, 7}, 6000);
  sut.add(80);
  const auto first = sut.due();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->mean, sut.learned().learned.mean);
  sut.add(20);
  EXPECT_FALSE(sut.due());  // suspected
  sut.add(80);
  ASSERT_TRUE(sut.due());
  sut.applied(*sut.due());
  EXPECT_EQ(sut.learned().in_force.mean, sut.learned().learned.mean);
  EXPECT_EQ(sut.learned().applied, 1U);
  EXPECT_FALSE(sut.due());
}

TEST(SiteLearner, WaitsAfterALawThatWasRefused) {
  SiteLearner sut(learning());
  feed(sut, {72, 7}, 6000);
  sut.add(80);
  ASSERT_TRUE(sut.due());
  sut.refused();
  for (int i = 0; i < 179; ++i) sut.add(75);
  EXPECT_FALSE(sut.due());
  sut.add(75);
  EXPECT_TRUE(sut.due());
  EXPECT_EQ(sut.learned().applied, 0U);
}

TEST(SiteLearner, ComesBackToTheConfiguredLawWhenTheBuildingDoes) {
  SiteLearner sut(learning());
  const auto drive = [&](const Normal& law, int samples) {
    Ar1Feed link(0);
    for (int i = 0; i < samples; ++i) {
      sut.add(link.next(law));
      if (const auto due = sut.due()) sut.applied(*due);
    }
  };
  drive({72, 7}, 10000);
  EXPECT_NEAR(sut.learned().in_force.mean, 72, 2);
  drive(thesis_good, 30000);
  EXPECT_NEAR(sut.learned().in_force.mean, thesis_good.mean, 0.3 * thesis_good.sd);
}

TEST(SiteLearner, SaysInALineWhatItProposes) {
  LearnedLaw law{{81.6, 10.3}, {74.12, 7.25}, {81.6, 10.3}, 431, -12.3, 4.6, 0.02, true, 0};
  EXPECT_EQ(text_of(law),
            "proposes good_mean 74.1, good_sd 7.2 for good_mean 81.6, good_sd 10.3: mean -12, "
            "spread +5 standard errors away, from samples worth 431");
  law.proposed = false;
  EXPECT_EQ(text_of(law), "nothing against good_mean 81.6, good_sd 10.3, from samples worth 431");
}

TEST(SiteLearner, IgnoresWhatIsNoQuality) {
  SiteLearner sut(learning());
  sut.add(NAN);
  sut.add(1e300);
  EXPECT_EQ(sut.learned().effective_samples, 0);
  EXPECT_EQ(sut.learned().left_out_share, 0);
}

TEST(SiteLearner, RejectsLimitsThatAreNone) {
  PolicyParams params = learning();
  params.learn_max_spread = 0.5;
  EXPECT_THROW(SiteLearner{params}, ConfigError);
}

}  // namespace
}  // namespace tocsin::decision
