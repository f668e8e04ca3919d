// SPDX-License-Identifier: Apache-2.0
#include "fit/fit_policies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;

/// Good slots around 80, bad ones around 50, in stretches of 30 and 10.
std::vector<Trace> two_states(int traces, double sd) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, sd);
  std::vector<Trace> all(static_cast<std::size_t>(traces));
  for (Trace& trace : all) {
    for (int i = 0; i < 120; ++i) {
      const bool bad = i % 40 >= 30;
      trace.bad.push_back(bad);
      trace.qni.push_back((bad ? 50 : 80) + noise(random));
    }
  }
  return all;
}

const Tuned& of(const MissionFit& fit, const std::string& policy) {
  return *std::find_if(fit.policies.begin(), fit.policies.end(),
                       [&](const Tuned& one) { return one.policy == policy; });
}

TEST(FitLaws, FindsMeansAndLengths) {
  const auto sut = fit_laws(two_states(10, 5), "a");
  EXPECT_NEAR(sut.good_mean, 80, 1);
  EXPECT_NEAR(sut.good_sd, 5, 0.5);
  EXPECT_NEAR(sut.bad_mean, 50, 1);
  EXPECT_NEAR(sut.bad_sd, 5, 0.5);
  EXPECT_NEAR(sut.mean_good_samples, 30, 1e-9);
  EXPECT_NEAR(sut.mean_bad_samples, 10, 1e-9);
}

TEST(FitLaws, LeavesOutSlotsWithoutASample) {
  auto traces = two_states(10, 5);
  for (Trace& trace : traces) trace.qni[3] = std::nan("");
  EXPECT_NEAR(fit_laws(traces, "a").good_mean, 80, 1);
}

TEST(FitLaws, NamesTheMissionThatHasNoPoorLink) {
  auto traces = two_states(2, 5);
  for (Trace& trace : traces) trace.bad.assign(trace.bad.size(), false);
  EXPECT_THAT(error_of([&] { (void)fit_laws(traces, "north"); }),
              HasSubstr("mission north, poor link"));
}

TEST(FitPolicies, PutsTheThresholdBetweenTheLaws) {
  const MissionFit sut = fit_policies(two_states(5, 3), "a");
  const Tuned& threshold = of(sut, "threshold");
  ASSERT_EQ(threshold.settings.size(), 2U);
  const double below = std::stod(threshold.settings[0].substr(threshold.settings[0].find('=') + 1));
  EXPECT_GE(below, 55);
  EXPECT_LT(below, 75);
  EXPECT_LT(threshold.regret, 60);
}

TEST(FitPolicies, GivesEachPolicyNoWorseThanItsDefaults) {
  const auto traces = two_states(5, 12);
  const MissionFit sut = fit_policies(traces, "a");
  EXPECT_LT(of(sut, "tocp").regret, of(sut, "none").regret);
  EXPECT_LE(of(sut, "tocp_dsp").regret, of(sut, "tocp").regret);
  EXPECT_LE(of(sut, "tocp_reverse").regret, of(sut, "tocp").regret);
}

TEST(FitPolicies, TunesTwoNumbersOfEachOrNone) {
  const MissionFit sut = fit_policies(two_states(2, 8), "a");
  EXPECT_EQ(sut.policies.size(), 7U);
  for (const Tuned& one : sut.policies) {
    EXPECT_TRUE(one.settings.empty() || one.settings.size() == 2U) << one.policy;
    EXPECT_TRUE(std::isfinite(one.regret)) << one.policy;
  }
}

TEST(FitPolicies, IsTheSameEachTime) {
  const auto traces = two_states(2, 8);
  EXPECT_EQ(settings_of(fit_policies(traces, "a")), settings_of(fit_policies(traces, "a")));
}

TEST(SettingsOf, HoldLawsOnceAndThePoliciesThatHaveNumbers) {
  const auto sut = settings_of(fit_policies(two_states(2, 8), "a"));
  EXPECT_THAT(sut, Contains(Key(every_policy)));
  EXPECT_THAT(sut, Contains(Key("tocp_dsp")));
  EXPECT_THAT(sut, Not(Contains(Key("none"))));
  EXPECT_EQ(sut.at(every_policy).size(), 6U);
}

TEST(TraceOf, TakesQualityAndTruthOfEachObservation) {
  std::vector<Observation> series(3);
  series[0].qni = 70;
  series[1].poor = 0.9;
  const Trace sut = trace_of(series);
  EXPECT_EQ(sut.qni[0], 70);
  EXPECT_EQ(sut.bad, (std::vector<bool>{false, true, false}));
}

TEST(FitLaws, TakesALengthOfOneForOneAndAHalf) {
  // A mean of one would say that the link never stays as it is.
  Trace trace;
  for (int i = 0; i < 100; ++i) {
    trace.bad.push_back(i % 2 == 0);
    trace.qni.push_back((i % 2 == 0 ? 50 : 80) + i % 7);
  }
  const auto sut = fit_laws({trace}, "a");
  EXPECT_EQ(sut.mean_good_samples, 1.5);
  EXPECT_EQ(sut.mean_bad_samples, 1.5);
}

TEST(FitLaws, CountsAStretchInEachTraceByItself) {
  // 20 good and 10 bad slots in either; what ends one trace does not go on in the next.
  std::vector<Trace> traces(2);
  for (Trace& trace : traces) {
    for (int i = 0; i < 30; ++i) {
      trace.bad.push_back(i >= 20);
      trace.qni.push_back((i >= 20 ? 50 : 80) + i % 5);
    }
  }
  const auto sut = fit_laws(traces, "a");
  EXPECT_DOUBLE_EQ(sut.mean_good_samples, 20);
  EXPECT_DOUBLE_EQ(sut.mean_bad_samples, 10);
}

TEST(TraceOf, KeepsSlotsWithoutASample) {
  const Observation silent{0, NAN, NAN, NAN, 1, 0.6, 0, 0, NAN, false};
  const Trace sut = trace_of({silent});
  ASSERT_EQ(sut.qni.size(), 1U);
  EXPECT_TRUE(std::isnan(sut.qni[0]));
  EXPECT_TRUE(sut.bad[0]);
}

}  // namespace
}  // namespace tocsin::experiment
