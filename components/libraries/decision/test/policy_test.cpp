// SPDX-License-Identifier: Apache-2.0
#include "decision/policy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "policy_feed.hpp"

namespace tocsin::decision {
namespace {

TEST(Policy, StartsActive) {
  for (const char* name : policy_names) {
    const auto sut = make_policy(params_for(name));
    EXPECT_EQ(sut->state(), State::active);
    EXPECT_STREQ(sut->name(), name);
  }
}

TEST(Policy, NoneNeverPauses) {
  Feed sut(params_for("none"));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(sut(0).state, State::active);
}

TEST(Policy, ThresholdHoldsBetweenItsBounds) {
  Feed sut(params_for("threshold"));
  EXPECT_EQ(sut(40).state, State::active);
  EXPECT_EQ(sut(39.9).reason, Reason::threshold_low);
  EXPECT_EQ(sut(49.9).state, State::passive);
  const Evidence resumed = sut(50);
  EXPECT_EQ(resumed.state, State::active);
  EXPECT_EQ(resumed.reason, Reason::threshold_high);
  EXPECT_EQ(sut(40).state, State::active);
}

TEST(Policy, ThresholdWaitsForSamplesInARow) {
  PolicyParams params = params_for("threshold");
  params.threshold_in_a_row = 2;
  Feed sut(params);
  EXPECT_FALSE(sut(30).changed);
  EXPECT_FALSE(sut(60).changed);
  EXPECT_FALSE(sut(30).changed);
  EXPECT_TRUE(sut(30).changed);
}

TEST(Policy, ThresholdSpeaksInOneForcedSlotOnlyWhileTheNetworkStaysBad) {
  PolicyParams params = params_for("threshold");
  params.threshold_in_a_row = 2;
  params.th_max_samples = 5;
  Feed sut(params);
  sut(30);
  EXPECT_TRUE(sut(30).changed);
  for (int k = 1; k < 5; ++k) sut(30);
  EXPECT_EQ(sut(30).reason, Reason::forced_resume_samples);
  EXPECT_EQ(sut(30).reason, Reason::threshold_low);
}

TEST(Policy, TocpPausesAtTheAlarmAndShowsItsEvidence) {
  Feed sut(params_for("tocp"));
  EXPECT_EQ(sut(85).statistic, 0);
  const Evidence evidence = sut(36.599);
  EXPECT_TRUE(evidence.changed);
  EXPECT_EQ(evidence.state, State::passive);
  EXPECT_EQ(evidence.reason, Reason::cusum_alarm);
  EXPECT_NEAR(evidence.statistic, 9.809356, 1e-6);
  EXPECT_EQ(evidence.threshold, 5.53);
  EXPECT_EQ(evidence.sample, 36.599);
  EXPECT_EQ(evidence.deadline, sut.now + std::chrono::seconds(180));
}

TEST(Policy, TocpResumesAfterItsFixedPause) {
  PolicyParams params = params_for("tocp");
  params.fixed_pause_samples = 5;
  Feed sut(params);
  sut(20);
  for (int i = 1; i < 5; ++i) EXPECT_EQ(sut(90).age, i);
  const Evidence evidence = sut(90);
  EXPECT_EQ(evidence.age, 5);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::fixed_pause_over);
}

TEST(Policy, DspResumesOnTheFirstRecordFromCandidateSeven) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  for (const double x : {30., 31., 32., 33., 34., 35.}) EXPECT_FALSE(sut(x).changed);
  EXPECT_FALSE(sut(35).changed);  // equal is no record
  const Evidence evidence = sut(35.1);
  EXPECT_EQ(evidence.reason, Reason::best_so_far);
  EXPECT_EQ(evidence.threshold, 35);
  EXPECT_EQ(evidence.age, 8);
}

TEST(Policy, DspIsForcedToResumeAtItsLastCandidate) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  sut(60);
  for (int k = 2; k < 30; ++k) EXPECT_EQ(sut(20).state, State::passive);
  const Evidence evidence = sut(20);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::forced_resume_samples);
  EXPECT_EQ(evidence.age, 30);
}

TEST(Policy, ReverseResumesWhenTheNetworkTurnsGood) {
  Feed sut(params_for("tocp_reverse"));
  sut(20);
  EXPECT_FALSE(sut(50).changed);
  EXPECT_EQ(sut(80).reason, Reason::reverse_alarm);
}

TEST(Policy, BeliefPausesAndResumesOnItsThresholds) {
  Feed sut(params_for("belief"));
  EXPECT_LT(sut(85).statistic, 0.01);
  const Evidence paused = sut(30);
  EXPECT_EQ(paused.reason, Reason::belief_bad);
  EXPECT_NEAR(paused.threshold, 0.631, 0.01);
  EXPECT_EQ(sut(85).reason, Reason::belief_good);
}

TEST(Policy, LegacyPausesOnOneSampleOfSmallRatio) {
  Feed sut(params_for("legacy"));
  for (int i = 0; i < 6; ++i) EXPECT_EQ(sut(85).state, State::active);
  EXPECT_EQ(sut(57.6).state, State::active);  // ln f0/f1 is 1 at 57.57
  EXPECT_EQ(sut(57.5).reason, Reason::legacy_drop);
}

TEST(Policy, LegacyIsHeldToTheLimitOfSilence) {
  PolicyParams params = params_for("legacy");
  params.th_max_samples = 10;
  Feed sut(params);
  for (int i = 0; i < 6; ++i) sut(85);
  sut(40);
  for (int k = 1; k < 10; ++k) EXPECT_EQ(sut(90).state, State::passive);
  EXPECT_EQ(sut(90).reason, Reason::forced_resume_samples);
  EXPECT_EQ(sut(90).state, State::passive);  // its own count goes on
}

TEST(Policy, ComputesItsThresholdFromTheWantedRunLength) {
  PolicyParams params = params_for("tocp_reverse");
  params.false_alarm_samples = 1000;
  params.false_resume_samples = 1000;
  Feed sut(params);
  EXPECT_NEAR(sut(85).threshold, 3.563, 1e-3);
  sut(20);
  EXPECT_NEAR(sut(20).threshold, 2.144, 1e-3);
}

TEST(Policy, TakesFittedLaws) {
  PolicyParams params = params_for("tocp");
  params.good_family = "beta";
  params.good_parameters = {10.9, 2.66};
  params.bad_family = "weibull";
  params.bad_parameters = {39.4, 5.2};
  params.false_alarm_samples = 3600;
  Feed sut(params);
  EXPECT_EQ(sut(100).state, State::active);
  EXPECT_EQ(sut(30).reason, Reason::cusum_alarm);
}

}  // namespace
}  // namespace tocsin::decision
