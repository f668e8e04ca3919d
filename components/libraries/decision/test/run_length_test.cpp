// SPDX-License-Identifier: Apache-2.0
#include "decision/run_length.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

const NormalLlr thesis;

double arl0(double alpha) { return mean_run_length(step_law(thesis, 0, thesis_good), alpha); }
double arl1(double alpha) { return mean_run_length(step_law(thesis, 0, thesis_bad), alpha); }

// Of the classical table: k = 1/2, h = 4 (Montgomery; R package spc agrees).
TEST(MeanRunLength, HasTheClassicalValue) {
  const StepLaw law{[](double y) { return std::erfc((y + 0.5) * M_SQRT1_2) / 2; }};
  EXPECT_NEAR(mean_run_length(law, 4) / 335.36758, 1, 1e-5);
}

// Mean samples between false alarms and delay of the thesis's laws.
TEST(MeanRunLength, HasTheKnownValuesOfTheThesisLaws) {
  EXPECT_NEAR(arl0(3) / 718.1, 1, 1e-3);
  EXPECT_NEAR(arl0(5) / 2498, 1, 1e-3);
  EXPECT_NEAR(arl0(10) / 161149, 1, 1e-3);
  EXPECT_NEAR(arl0(20) / 4.355e9, 1, 1e-3);
  EXPECT_NEAR(arl1(5), 1.0834, 1e-4);
  EXPECT_NEAR(arl1(12), 1.8360, 1e-4);
}

TEST(MeanRunLength, KeepsItsDigitsForVeryRareAlarms) { EXPECT_NEAR(arl0(30) / 1.034e14, 1, 1e-3); }

TEST(MeanRunLength, GrowsWithClippingOnceTwoSamplesAreNeeded) {
  const NormalLlr clipped(thesis_good, thesis_bad, 4);
  const double below = mean_run_length(step_law(clipped, 4, thesis_good), 3.5, false);
  const double above = mean_run_length(step_law(clipped, 4, thesis_good), 6.9, false);
  EXPECT_NEAR(below / 997, 1, 0.1);     // simulated
  EXPECT_NEAR(above / 546060, 1, 0.1);  // simulated
}

double simulated(const NormalLlr& llr, Normal truth, double alpha) {
  std::mt19937_64 random(5);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> law(truth.mean, truth.sd);
  double samples = 0;
  constexpr int alarms = 4000;
  for (int i = 0; i < alarms; ++i) {
    for (Cusum cusum; !cusum.alarm(alpha); ++samples) cusum.add(llr(law(random)));
  }
  return samples / alarms;
}

TEST(MeanRunLength, AgreesWithSimulationAlsoWhereTheRatioIsHeld) {
  for (const NormalLlr& llr : {NormalLlr({80, 20}, {50, 10}), NormalLlr({80, 10}, {50, 30})}) {
    const StepLaw law = step_law(llr, 0, llr.good());
    EXPECT_NEAR(mean_run_length(law, 2, false) / simulated(llr, llr.good(), 2), 1, 0.06);
  }
}

TEST(MeanRunLength, AgreesBetweenExactAndGridLaws) {
  const Density good(Family::normal, {70, 8, 0});
  const Density bad(Family::normal, {45, 8, 0});
  const NormalLlr exact({70, 8}, {45, 8});
  const Llr grid{DensityLlr(good, bad, 0)};
  EXPECT_NEAR(
      mean_run_length(step_law(grid, good), 4) / mean_run_length(step_law(exact, 0, {70, 8}), 4), 1,
      0.01);
  EXPECT_NEAR(mean_run_length(reverse_step_law(grid, bad), 4) /
                  mean_run_length(reverse_step_law(exact, 0, {45, 8}), 4),
              1, 0.01);
}

TEST(AlphaForRunLength, HasTheKnownThresholds) {
  const StepLaw law = step_law(thesis, 0, thesis_good);
  EXPECT_NEAR(alpha_for_run_length(law, 1000), 3.563, 1e-3);
  EXPECT_NEAR(alpha_for_run_length(law, 3600), 5.530, 1e-3);
  EXPECT_NEAR(alpha_for_run_length(reverse_step_law(thesis, 0, thesis_bad), 3600), 3.857, 1e-3);
}

std::string error_of(double samples) {
  try {
    (void)alpha_for_run_length(step_law(thesis, 0, thesis_good), samples);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AlphaForRunLength, RejectsWhatNoThresholdGives) {
  EXPECT_THAT(error_of(100),
              ::testing::HasSubstr("cannot be had with these laws, must be above 153"));
  EXPECT_EQ(error_of(155), "no error");
}

nlohmann::json thesis_table() {
  return nlohmann::json::parse(std::ifstream(golden_file("cusum_arl_thesis_f0f1.json")));
}

TEST(MeanRunLength, AgreesWithTheGoldenTable) {
  if (golden_file("cusum_arl_thesis_f0f1.json").empty()) GTEST_SKIP() << "no golden numbers";
  Deviations numbers;
  const auto file = thesis_table();
  for (const auto& row : file["table"]) {
    const double alpha = row["alpha"];
    numbers.relative(arl0(alpha), row["ARL0_f0"], 1e-3);
    numbers.relative(arl1(alpha), row["ARL1_zero_state"], 1e-4);
    numbers.relative(mean_run_length(reverse_step_law(thesis, 0, thesis_bad), alpha),
                     row["rev_ARL0_f1"], 1e-3);
    numbers.relative(mean_run_length(reverse_step_law(thesis, 0, thesis_good), alpha),
                     row["rev_ARL1_zero_state"], 1e-4);
  }
  std::cout << "cusum_arl_thesis_f0f1: " << numbers.summary() << '\n';
  EXPECT_EQ(numbers.compared(), 80);
  EXPECT_EQ(numbers.outside(), 0);
}

TEST(AlphaForRunLength, StandsAThresholdThatIsNeverReached) {
  // On a lattice for alpha 1 a rise of 0.0001 is none at all.
  const StepLaw tiny{[](double y) { return y < -1 ? 1.0 : y < 1e-4 ? 0.01 : 0.0; }};
  const double alpha = alpha_for_run_length(tiny, 1000, false);
  EXPECT_GT(alpha, 0);
  EXPECT_LT(alpha, 3e-4);
}

TEST(AlphaForRunLength, HasNoMoreFalseAlarmsThanWantedWhereTheRunLengthJumps) {
  for (const double samples : {500.0, 3000.0, 20000.0}) {
    const StepLaw law = step_law(NormalLlr(thesis_good, thesis_bad, 4), 4, thesis_good);
    const double alpha = alpha_for_run_length(law, samples, false);
    EXPECT_GE(mean_run_length(law, alpha, false), samples * (1 - 1e-9)) << samples;
  }
}

TEST(AlphaForRunLength, AgreesWithTheGoldenTable) {
  if (golden_file("cusum_arl_thesis_f0f1.json").empty()) GTEST_SKIP() << "no golden numbers";
  Deviations numbers;
  int impossible = 0;
  const auto file = thesis_table();
  for (const auto& row : file["alpha_for_ARL0"]) {
    if (row["alpha"].is_null()) {
      EXPECT_NE(error_of(row["ARL0"]), "no error");
      ++impossible;
      continue;
    }
    const StepLaw law = step_law(thesis, 0, thesis_good);
    numbers.relative(alpha_for_run_length(law, row["ARL0"]), row["alpha"], 1e-3);
    const StepLaw reverse = reverse_step_law(thesis, 0, thesis_bad);
    numbers.relative(alpha_for_run_length(reverse, row["ARL0"]), row["alpha_rev"], 1e-3);
  }
  std::cout << "alpha_for_ARL0: " << numbers.summary() << "; " << impossible << " impossible\n";
  EXPECT_EQ(numbers.compared() + 2 * impossible, 22);
  EXPECT_EQ(numbers.outside(), 0);
}

}  // namespace
}  // namespace tocsin::decision
