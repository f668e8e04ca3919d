// SPDX-License-Identifier: Apache-2.0
// The detectors that a policy may have, their designed thresholds, and what the policy does with
// them.
#include "decision/detectors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "decision/false_alarms.hpp"
#include "decision/policy_model.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"
#include "golden.hpp"
#include "policy_feed.hpp"

namespace tocsin::decision {
namespace {

/// The statistic of FOCuS by its definition.
double brute_force(const std::vector<double>& z, std::uint32_t& run) {
  double best = 0;
  double sum = 0;
  for (std::size_t m = 1; m <= z.size(); ++m) {
    sum += z[z.size() - m];
    const double value = sum > 0 ? sum * sum / (2.0 * static_cast<double>(m)) : 0;
    if (value > best) run = static_cast<std::uint32_t>(m);
    best = std::max(best, value);
  }
  if (best == 0) run = 0;
  return best;
}

TEST(Focus, EqualsTheMaximumOverAllChangeTimesAndSizes) {
  std::mt19937_64 random(11);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> noise(0, 1);
  Focus sut({0, 1});
  std::vector<double> z;
  for (int i = 0; i < 2000; ++i) {
    const double fall = i % 500 > 400 ? 0.4 : 0;
    z.push_back(noise(random) + fall);
    std::uint32_t run = 0;
    const double want = brute_force(z, run);
    ASSERT_NEAR(sut.add(-z.back()), want, 1e-9 * (1 + want)) << i;
    ASSERT_EQ(sut.run(), run) << i;
  }
}

TEST(Focus, StaysBelowTheTruthAndCloseToItOnALongRamp) {
  Focus sut({0, 1});
  std::vector<double> z;
  for (int i = 1; i <= 300; ++i) {
    z.push_back(0.01 * i);
    std::uint32_t run = 0;
    const double want = brute_force(z, run);
    const double got = sut.add(-z.back());
    ASSERT_LE(got, want * (1 + 1e-12));
    ASSERT_GE(got, want * 0.97) << i;
  }
}

TEST(Focus, SeesFallsOnly) {
  Focus sut;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(sut.add(95), 0);
  EXPECT_GT(sut.add(40), 6.1);
  EXPECT_EQ(sut.run(), 1U);
}

TEST(Focus, IgnoresNanAndStartsAgain) {
  Focus sut;
  const double before = sut.add(60);
  EXPECT_EQ(sut.add(NAN), before);
  sut.reset();
  EXPECT_EQ(sut.statistic(), 0);
  EXPECT_EQ(sut.add(60), before);
}

TEST(Focus, RejectsASpreadOfZero) { EXPECT_THROW(Focus({80, 0}), ConfigError); }

void follow(const char* name) {
  const auto path = golden_file(name);
  if (path.empty()) GTEST_SKIP() << "no golden numbers on this machine";
  Table t = read_table(path);
  Focus focus;
  Deviations numbers;
  for (std::size_t n = 0; n < t.rows; ++n) {
    numbers.relative(focus.add(t.columns["qni"][n]), t.columns["focus_down"][n], 1e-9);
  }
  std::cout << name << ' ' << numbers.summary() << '\n';
  EXPECT_EQ(numbers.outside(), 0);
  EXPECT_EQ(numbers.compared(), 1500);
}

TEST(Focus, FollowsGoldenTrace1) { follow("trace1_iid.csv"); }
TEST(Focus, FollowsGoldenTrace2) { follow("trace2_ar_ramp.csv"); }

PolicyParams with_detector(DetectorKind detector, double false_alarm_samples) {
  PolicyParams params = params_for("tocp_reverse");
  params.detector = detector;
  params.false_alarm_samples = false_alarm_samples;
  return params;
}

constexpr DetectorKind cusum = DetectorKind::cusum;
constexpr DetectorKind focus = DetectorKind::focus;

TEST(DetectorThreshold, IsTheOneThatHasTheWantedRunLength) {
  // FOCuS: found by an independent program
  EXPECT_NEAR(detector_threshold_of(with_detector(focus, 1012.5)), 6.1215, 0.12);
  EXPECT_NEAR(detector_threshold_of(with_detector(cusum, 1000)), 3.563, 1e-3);
}

TEST(DetectorThreshold, HoldsBeyondWhatIsSimulated) {
  const PolicyParams params = with_detector(focus, 10000);
  const auto source = independent(thesis_good, 77);
  const FalseAlarmCurve curve(*source, *detector_of(params), {300, 20000});
  EXPECT_NEAR(curve.run_length(detector_threshold_of(params)) / 10000, 1, 0.2);
}

TEST(DetectorThreshold, OfAnotherDetectorAlarmsAsRarelyAsAlphaSays) {
  PolicyParams params = with_detector(focus, 0);
  params.alpha = 3.563;
  EXPECT_NEAR(detector_threshold_of(params), 6.11, 0.12);
  params.detector_threshold = 9;
  EXPECT_EQ(detector_threshold_of(params), 9);
}

TEST(DetectorThreshold, RejectsWhatNoThresholdGives) {
  try {
    (void)detector_threshold_of(with_detector(focus, 1.5));
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

// Delays at one false alarm in 1,000 samples; the expected values were found by an independent
// program.
TEST(EveryDetector, FindsASuddenFallInTheFirstSampleAndAMildOneAsFastAsItShould) {
  const struct {
    DetectorKind detector;
    Normal truth;
    int before;
    double delay;
    double tolerance;
  } rows[] = {{cusum, thesis_bad, 0, 1.04, 0.02},
              {focus, thesis_bad, 0, 1.11, 0.02},
              {cusum, {70, thesis_good.sd}, 0, 40, 4},
              {focus, {70, thesis_good.sd}, 50, 8.6, 0.5}};
  for (const auto& row : rows) {
    EXPECT_NEAR(delay(with_detector(row.detector, 1000), row.truth, row.before, 3000), row.delay,
                row.tolerance)
        << word_of(row.detector) << ' ' << row.truth.mean;
  }
}

TEST(EveryDetector, StartsAfreshAfterResetAndIgnoresNan) {
  for (const DetectorKind kind : {cusum, focus}) {
    const auto sut = detector_of(with_detector(kind, 1000));
    const double first = sut->add(40);
    const double second = sut->add(40);
    EXPECT_GT(second, first) << word_of(kind);
    EXPECT_EQ(sut->add(nan), second) << word_of(kind);
    sut->reset();
    EXPECT_EQ(sut->add(40), first) << word_of(kind);
  }
}

TEST(EveryDetector, PausesAtItsAlarmAndIsForgottenInAGap) {
  for (const auto& [kind, reason] :
       {std::pair{cusum, Reason::cusum_alarm}, {focus, Reason::detector_alarm}}) {
    Feed sut(with_detector(kind, 1e6));
    const double fresh = sut(54).statistic;
    EXPECT_GT(sut(54).statistic, fresh) << word_of(kind);
    sut.now += std::chrono::seconds(100);
    EXPECT_EQ(sut(54).statistic, fresh) << word_of(kind);
    const Evidence evidence = sut(20);
    EXPECT_EQ(evidence.state, State::passive) << word_of(kind);
    EXPECT_EQ(evidence.reason, reason) << word_of(kind);
    EXPECT_GE(evidence.statistic, evidence.threshold) << word_of(kind);
  }
}

}  // namespace
}  // namespace tocsin::decision
