// SPDX-License-Identifier: Apache-2.0
// The detectors that a policy may have, their designed thresholds, and what the policy does with
// them.
#include "decision/detector.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "decision/false_alarms.hpp"
#include "decision/policy.hpp"
#include "decision/policy_model.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

PolicyParams with_detector(const std::string& detector, double false_alarm_samples) {
  PolicyParams params;
  params.policy = "tocp_reverse";
  params.detector = detector;
  params.false_alarm_samples = false_alarm_samples;
  return params;
}

double run_length(const PolicyParams& params, Normal truth, double horizon, int paths) {
  const auto source = independent(Density(Family::normal, {truth.mean, truth.sd, 0}), 77);
  return FalseAlarmCurve(*source, detector_of(params), {paths, horizon})
      .run_length(detector_threshold_of(params));
}

TEST(DetectorThreshold, IsTheOneThatHasTheWantedRunLength) {
  // found by an independent program: FOCuS 1012.5 at 6.1215, Shiryaev-Roberts 1003.7 at 3.6169
  EXPECT_NEAR(detector_threshold_of(with_detector("focus", 1012.5)), 6.1215, 0.12);
  EXPECT_NEAR(detector_threshold_of(with_detector("shiryaev_roberts", 1003.7)), 3.6169, 0.2);
  EXPECT_NEAR(detector_threshold_of(with_detector("cusum", 1000)), 3.563, 1e-3);
}

TEST(DetectorThreshold, HoldsBeyondWhatIsSimulated) {
  for (const char* detector : {"focus", "shiryaev_roberts"}) {
    const double real = run_length(with_detector(detector, 10000), thesis_good, 20000, 300);
    EXPECT_NEAR(real / 10000, 1, 0.2) << detector;
  }
}

TEST(DetectorThreshold, OfAnotherDetectorAlarmsAsRarelyAsAlphaSays) {
  PolicyParams params = with_detector("focus", 0);
  params.alpha = 3.563;
  EXPECT_NEAR(detector_threshold_of(params), 6.11, 0.12);
  params.detector_threshold = 9;
  EXPECT_EQ(detector_threshold_of(params), 9);
}

TEST(DetectorThreshold, RejectsWhatNoThresholdGives) {
  try {
    (void)detector_threshold_of(with_detector("focus", 1.5));
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("1.5: cannot be had with detector focus"));
  }
}

/// Mean samples until the policy pauses; the link is good for `before` samples, then follows
/// `truth`. Runs with an earlier pause are left out.
double delay(const PolicyParams& params, Normal truth, int before, int runs) {
  const auto sut = make_policy(params);
  std::mt19937_64 random(3);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> z(0, 1);
  long samples = 0;
  long counted = 0;
  Time now{};
  for (int i = 0; i < runs; ++i) {
    now += std::chrono::hours(1);  // a gap: nothing is known any more
    bool paused = false;
    for (int n = 0; n < before && !paused; ++n) {
      const double x = thesis_good.mean + thesis_good.sd * z(random);
      paused = sut->on_sample({now, std::clamp(x, 0.0, 100.0)}, now).state == State::passive;
    }
    const bool early = paused;
    while (!paused) {
      const double x = truth.mean + truth.sd * z(random);
      paused = sut->on_sample({now, std::clamp(x, 0.0, 100.0)}, now).state == State::passive;
      ++samples;
    }
    counted += !early;
    now += std::chrono::hours(1);
    (void)sut->on_deadline(now);
  }
  return static_cast<double>(samples) / static_cast<double>(counted);
}

PolicyParams with_mild(double false_alarm_samples) {
  PolicyParams params = with_detector("cusum", false_alarm_samples);
  params.mild_mean = 70;
  params.mild_share = 0.83;
  return params;
}

const Normal mild{70, thesis_good.sd};

TEST(MildShare, DividesTheFalseAlarmsBetweenBothCusums) {
  const PolicyParams params = with_mild(1000);
  EXPECT_NEAR(alpha_of(params), 6.21, 0.02);  // 1000 / 0.17
  EXPECT_NEAR(mild_alpha_of(params), 5.35, 0.1);
  EXPECT_NEAR(delay(params, thesis_good, 0, 400) / 1000, 1, 0.1);
}

TEST(MildShare, FindsAMildFallInNineSamplesWhereTheCusumNeedsForty) {
  EXPECT_LE(delay(with_mild(1000), mild, 0, 4000), 9);
  EXPECT_GT(delay(with_detector("cusum", 1000), mild, 0, 1000), 36);
}

TEST(Detector, FocusFindsAMildFallInNineSamplesOnceTheLinkWasGood) {
  EXPECT_LE(delay(with_detector("focus", 1000), mild, 50, 4000), 9);
}

TEST(Detector, SuddenFallsAreFoundInTheFirstSampleByAll) {
  EXPECT_NEAR(delay(with_detector("cusum", 1000), thesis_bad, 0, 10000), 1.04, 0.02);
  EXPECT_NEAR(delay(with_detector("focus", 1000), thesis_bad, 0, 10000), 1.11, 0.02);
  EXPECT_NEAR(delay(with_detector("shiryaev_roberts", 1000), thesis_bad, 0, 10000), 1.04, 0.02);
  EXPECT_NEAR(delay(with_mild(1000), thesis_bad, 0, 10000), 1.13, 0.02);
}

TEST(Detector, FocusWatchesAnyLawByItsNormalScores) {
  PolicyParams params = with_detector("focus", 1000);
  params.good_family = "beta";
  params.good_parameters = {10.68, 2.41};
  const Density law = good_law_of(params);
  const auto source = independent(law, 5);
  const double threshold = detector_threshold_of(params);
  EXPECT_NEAR(threshold, 6.11, 0.15);  // as for a normal law
  const FalseAlarmCurve curve(*source, detector_of(params), {500, 4000});
  EXPECT_NEAR(curve.run_length(threshold) / 1000, 1, 0.15);
}

TEST(MildShare, HoldsForALawThatIsNotNormal) {
  PolicyParams params = with_mild(1000);
  params.good_family = "logistic";
  params.good_parameters = {thesis_good.mean, 5};
  const auto source = independent(good_law_of(params), 12);
  const FalseAlarmCurve curve(*source, Detector::cusum(mild_llr_of(params)), {500, 3000});
  EXPECT_NEAR(curve.run_length(mild_alpha_of(params)) / (1000 / 0.83), 1, 0.15);
}

TEST(MildShare, LeavesAlphaAloneWhenItIsOff) {
  PolicyParams params = with_detector("cusum", 0);
  params.mild_alpha = 4.2;
  EXPECT_EQ(alpha_of(params), params.alpha);
  EXPECT_EQ(mild_alpha_of(params), 4.2);
}

TEST(MildShare, KeepsTheFalseAlarmsThatAlphaStatesAlone) {
  PolicyParams params = with_mild(0);
  params.alpha = 3.563;  // 1000 samples
  EXPECT_NEAR(alpha_of(params), alpha_of(with_mild(1000)), 1e-2);
  EXPECT_NEAR(mild_alpha_of(params), mild_alpha_of(with_mild(1000)), 1e-2);
}

TEST(DetectorThreshold, LeavesTheSecondCusumItsShareWithEveryDetector) {
  for (const char* name : {"focus", "shiryaev_roberts"}) {
    PolicyParams params = with_detector(name, 500);
    const double alone = detector_threshold_of(params);
    params.mild_share = 0.5;
    EXPECT_GT(detector_threshold_of(params), alone + 0.3) << name;
    EXPECT_NEAR(detector_threshold_of(params), detector_threshold_of(with_detector(name, 1000)),
                1e-9);
  }
}

TEST(DetectorThreshold, IsTheSameEachTime) {
  for (const char* name : {"cusum", "focus", "shiryaev_roberts"}) {
    const PolicyParams params = with_detector(name, 2500);
    EXPECT_EQ(detector_threshold_of(params), detector_threshold_of(params)) << name;
  }
}

TEST(DetectorThreshold, OfShiryaevRobertsHoldsForOtherLaws) {
  PolicyParams params = with_detector("shiryaev_roberts", 1500);
  params.bad_mean = 62;
  params.bad_sd = 12;
  const auto source = independent(good_law_of(params), 21);
  const FalseAlarmCurve curve(*source, detector_of(params), {300, 3000});
  EXPECT_NEAR(curve.run_length(detector_threshold_of(params)) / 1500, 1, 0.25);
}

TEST(NormalScores, AreTheNormalQuantilesOfTheLaw) {
  const NormalScores sut(Density(Family::normal, {60, 5, 0}));
  EXPECT_NEAR(sut(60), 0, 1e-9);
  EXPECT_NEAR(sut(50.03), -1.994, 1e-2);
  EXPECT_EQ(sut(-5), -8);
  EXPECT_EQ(sut(200), 8);
  EXPECT_TRUE(std::isnan(sut(nan)));
}

TEST(Detector, StartsAfreshAfterResetAndIgnoresNan) {
  for (const char* name : {"cusum", "focus", "shiryaev_roberts"}) {
    Detector sut = detector_of(with_detector(name, 1000));
    const double first = sut.add(40);
    const double second = sut.add(40);
    EXPECT_GT(second, first) << name;
    EXPECT_EQ(sut.add(nan), second) << name;
    sut.reset();
    EXPECT_EQ(sut.add(40), first) << name;
  }
}

TEST(PolicyWithDetector, PausesAtItsAlarmAndSaysWhose) {
  for (const auto& [name, reason] : {std::pair{"cusum", Reason::cusum_alarm},
                                     {"focus", Reason::focus_alarm},
                                     {"shiryaev_roberts", Reason::roberts_alarm}}) {
    const auto sut = make_policy(with_detector(name, 1000));
    Time now{};
    EXPECT_EQ(sut->on_sample({now, 82}, now).state, State::active);
    const Evidence evidence = sut->on_sample({now, 20}, now);
    EXPECT_EQ(evidence.state, State::passive) << name;
    EXPECT_EQ(evidence.reason, reason) << name;
    EXPECT_GE(evidence.statistic, evidence.threshold) << name;
  }
}

TEST(PolicyWithDetector, IsForgottenInAGap) {
  const auto sut = make_policy(with_detector("focus", 1000));
  Time now{};
  const double fresh = sut->on_sample({now, 68}, now).statistic;
  EXPECT_GT(sut->on_sample({now, 68}, now).statistic, fresh);
  now += std::chrono::seconds(100);
  EXPECT_EQ(sut->on_sample({now, 68}, now).statistic, fresh);
}

}  // namespace
}  // namespace tocsin::decision
