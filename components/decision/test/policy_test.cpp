// SPDX-License-Identifier: Apache-2.0
#include "decision/policy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <random>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"

namespace tocsin::decision {
namespace {

using std::chrono::seconds;
const Time t0{seconds(1000)};
const char* const all_policies[] = {"none",         "threshold", "tocp",  "tocp_dsp",
                                    "tocp_reverse", "belief",    "legacy"};

PolicyParams params_for(const std::string& policy) {
  PolicyParams params;
  params.policy = policy;
  return params;
}

/// Feeds one sample per second.
class Feed {
 public:
  explicit Feed(const PolicyParams& params) : policy(make_policy(params)) {}
  Evidence operator()(double qni) {
    now += seconds(1);
    return policy->on_sample({now, qni}, now);
  }
  std::unique_ptr<Policy> policy;
  Time now = t0;
};

TEST(Policy, StartsActive) {
  for (const char* name : all_policies) {
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
  EXPECT_EQ(evidence.deadline, sut.now + seconds(180));
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

TEST(Policy, ResumesAtTheDeadlineWhenSamplesStop) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  const Time paused = sut.now;
  EXPECT_FALSE(sut.policy->on_deadline(paused + seconds(180) - Duration{1}).changed);
  const Evidence evidence = sut.policy->on_deadline(paused + seconds(180));
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::forced_resume_time);
  EXPECT_FALSE(evidence.deadline.has_value());
}

TEST(Policy, ResumesByTimeOnALateSample) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  sut.now += seconds(179);
  EXPECT_EQ(sut(20).reason, Reason::forced_resume_time);
}

TEST(Policy, IgnoresADeadlineWhileActive) {
  const auto sut = make_policy(params_for("tocp"));
  const Evidence evidence = sut->on_deadline(t0);
  EXPECT_FALSE(evidence.changed);
  EXPECT_EQ(evidence.state, State::active);
}

TEST(Policy, DoesNotCountNanAsEvidence) {
  for (const char* name : {"threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief"}) {
    Feed sut(params_for(name));
    for (const double x : {double(NAN), double(INFINITY), double(-INFINITY)}) {
      const Evidence evidence = sut(x);
      EXPECT_EQ(evidence.reason, Reason::no_measurement);
      EXPECT_EQ(evidence.state, State::active);
    }
    sut(20);
    EXPECT_EQ(sut(NAN).state, State::passive) << name;
  }
}

TEST(Policy, CountsSamplesWithoutMeasurementInThePause) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  for (int k = 1; k < 30; ++k) EXPECT_EQ(sut(NAN).age, k);
  EXPECT_EQ(sut(NAN).reason, Reason::forced_resume_samples);
}

TEST(Policy, DoesNotUseAStaleSample) {
  Feed sut(params_for("tocp"));
  sut(85);
  const Evidence evidence = sut.policy->on_sample({t0, 0}, sut.now);
  EXPECT_EQ(evidence.reason, Reason::stale_sample);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_TRUE(std::isnan(evidence.sample));
}

TEST(Policy, RecoversFromAStampOfTheFuture) {
  Feed sut(params_for("tocp"));
  sut.policy->on_sample({Time::max(), 85}, sut.now);
  EXPECT_EQ(sut(20).reason, Reason::cusum_alarm);
}

TEST(Policy, GoesOnWhenTheClockIsSetBack) {
  Feed sut(params_for("tocp"));
  sut(85);
  sut.now -= seconds(500);
  EXPECT_EQ(sut(20).reason, Reason::cusum_alarm);
  sut.now -= seconds(500);
  const Evidence evidence = sut(20);
  EXPECT_EQ(evidence.deadline, sut.now + seconds(180));
  EXPECT_TRUE(sut.policy->on_deadline(sut.now + seconds(180)).changed);
}

TEST(Policy, VoidsOldEvidenceAfterAGap) {
  Feed sut(params_for("tocp"));
  EXPECT_GT(sut(50).statistic, 3);
  sut.now += seconds(60);
  EXPECT_LT(sut(50).statistic, 4);
  EXPECT_EQ(sut(50).reason, Reason::cusum_alarm);
}

TEST(Policy, KeepsEvidenceAcrossAShorterGap) {
  Feed sut(params_for("tocp"));
  sut(50);
  sut.now += seconds(59);
  EXPECT_EQ(sut(50).reason, Reason::cusum_alarm);
}

TEST(Policy, BeliefPausesAndResumesOnItsThresholds) {
  Feed sut(params_for("belief"));
  EXPECT_LT(sut(85).statistic, 0.01);
  const Evidence paused = sut(30);
  EXPECT_EQ(paused.reason, Reason::belief_bad);
  EXPECT_NEAR(paused.threshold, 0.631, 0.01);
  EXPECT_EQ(sut(85).reason, Reason::belief_good);
}

TEST(Policy, BeliefFallsBackToTheLongRunAfterAGap) {
  Feed sut(params_for("belief"));
  sut(85);
  sut.now += seconds(100);
  EXPECT_NEAR(sut(NAN).statistic, 20 / 140.0, 1e-9);
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

TEST(Policy, MildDegradationPausesOnlyWithItsOwnCusum) {
  PolicyParams params = params_for("tocp_reverse");
  Feed blind(params);
  params.mild_alpha = 5.35;
  Feed sut(params);
  Evidence last;
  for (int i = 0; i < 10 && !last.changed; ++i) {
    EXPECT_FALSE(blind(60).changed);
    last = sut(60);
  }
  EXPECT_EQ(last.reason, Reason::mild_alarm);
  EXPECT_EQ(last.threshold, 5.35);
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

/// Longest run of silence, in samples and in clock steps forward, on hostile input.
TEST(Policy, IsNeverSilentBeyondItsLimits) {
  std::mt19937 random(20190621);  // NOLINT: a fixed seed is the point
  for (const char* name : all_policies) {
    PolicyParams params = params_for(name);
    params.th_max_samples = params.fixed_pause_samples = 12;
    params.th_max_s = 20;
    const auto sut = make_policy(params);
    Time now = t0;
    int samples = 0;
    Duration silent{};
    for (int i = 0; i < 50000; ++i) {
      const Duration step =
          seconds(int(random() % 4)) - (random() % 20 == 0 ? seconds(900) : seconds(0));
      now += step;
      const double x = random() % 5 == 0 ? NAN : double(random() % 140) - 20;
      const bool was_passive = sut->state() == State::passive;
      const Evidence evidence = random() % 10 == 0
                                    ? sut->on_deadline(now)
                                    : sut->on_sample({now - seconds(int(random() % 3)), x}, now);
      if (was_passive) silent += std::max(step, Duration{});
      if (evidence.state == State::active) {
        silent = Duration{};
        samples = 0;
        continue;
      }
      samples += evidence.age > 0;
      ASSERT_LT(evidence.age, 12) << name;
      ASSERT_LT(silent, seconds(20)) << name;
      ASSERT_TRUE(evidence.deadline);
      ASSERT_LE(*evidence.deadline, now + seconds(20)) << name;
    }
  }
}

std::string error_of(const std::string& yaml) {
  try {
    (void)make_policy(load_parameters<PolicyParams>(YAML::Load(yaml), "policy", "p.yaml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PolicyParams, AcceptTheirDefaults) { EXPECT_EQ(error_of(""), "no error"); }

TEST(PolicyParams, RejectContradictions) {
  using ::testing::HasSubstr;
  EXPECT_THAT(error_of("{pause_below_qni: 60}"), HasSubstr("pause_below_qni: 60 must be at most"));
  EXPECT_EQ(error_of("{pause_below_qni: 50}"), "no error");
  EXPECT_THAT(error_of("{policy: tocp, fixed_pause_samples: 31}"), HasSubstr("at most th_max"));
  EXPECT_THAT(error_of("{discount_value: 0}"), HasSubstr("discount_value: 0"));
  EXPECT_EQ(error_of("{discount_value: 0, discount: linear}"), "no error");
  EXPECT_THAT(error_of("{bad_mean: 90}"), HasSubstr("must be above that of the bad law"));
  EXPECT_THAT(error_of("{good_family: cauchy}"), HasSubstr("'cauchy' is not one of: normal"));
  EXPECT_THAT(error_of("{good_family: beta, good_parameters: [1]}"), HasSubstr("beta has a b"));
  EXPECT_THAT(error_of("{false_alarm_samples: 100}"), HasSubstr("must be above 153"));
  EXPECT_THAT(error_of("{policy: belief, cost_silent_bad: 1}"), HasSubstr("below cost_send_bad"));
  EXPECT_THAT(error_of("{mild_alpha: 5, mild_mean: 90}"), HasSubstr("must be above that of"));
  EXPECT_THAT(error_of("{policy: magic}"), HasSubstr("'magic' is not one of"));
}

TEST(PolicyParams, RejectAnUnknownPolicySetInCode) {
  EXPECT_THROW((void)make_policy(params_for("magic")), ConfigError);
}

TEST(Reason, HasAWordForEach) {
  EXPECT_STREQ(to_string(Reason::cusum_alarm), "cusum_alarm");
  EXPECT_STREQ(to_string(Reason::forced_resume_time), "forced_resume_time");
  EXPECT_STREQ(to_string(State::passive), "passive");
}

}  // namespace
}  // namespace tocsin::decision
