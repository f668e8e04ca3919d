// SPDX-License-Identifier: Apache-2.0
// From parameters to laws, ratios and thresholds, and the law of a CUSUM's step against samples.
#include "decision/policy_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

using ::testing::HasSubstr;

double run_length_of(const PolicyParams& p, const StepLaw& law, double threshold) {
  return mean_run_length(law, threshold, p.llr_clip == 0);
}

TEST(PolicyThresholds, AreThoseThatWereGivenWhenNothingReplacesThem) {
  PolicyParams p;
  p.alpha = 4.5;
  p.reverse_alpha = 2.5;
  EXPECT_EQ(alpha_of(p), 4.5);
  EXPECT_EQ(reverse_alpha_of(p), 2.5);
  EXPECT_NEAR(false_alarm_samples_of(p), run_length_of(p, step_law_of(p, good_law_of(p)), 4.5), 1);
}

TEST(PolicyThresholds, HaveTheRunLengthsThatAreWanted) {
  for (const double clip : {0.0, 3.0}) {
    PolicyParams p;
    p.llr_clip = clip;
    p.false_alarm_samples = 5000;
    p.false_resume_samples = 800;
    const StepLaw alarm = step_law_of(p, good_law_of(p));
    const StepLaw resume = reverse_step_law_of(p, bad_law_of(p));
    // with a clip the run length rises in jumps, so that only its neighbours bound it
    EXPECT_GE(run_length_of(p, alarm, 1.001 * alpha_of(p)), 5000) << clip;
    EXPECT_LE(run_length_of(p, alarm, 0.999 * alpha_of(p)), 5000) << clip;
    EXPECT_GE(run_length_of(p, resume, 1.001 * reverse_alpha_of(p)), 800) << clip;
    EXPECT_LE(run_length_of(p, resume, 0.999 * reverse_alpha_of(p)), 800) << clip;
    EXPECT_EQ(false_alarm_samples_of(p), 5000);
  }
}

TEST(PolicyLaws, OfANormalFamilyAreThoseOfMeanAndDeviation) {
  PolicyParams by_family;
  by_family.good_parameters = {70, 8};
  by_family.good_mean = 99;
  PolicyParams by_mean;
  by_mean.good_mean = 70;
  by_mean.good_sd = 8;
  EXPECT_EQ(good_law_of(by_family).parameters(), good_law_of(by_mean).parameters());
  EXPECT_EQ(llr_of(by_family)(50), llr_of(by_mean)(50));
  EXPECT_EQ(alpha_of(by_family), alpha_of(by_mean));
}

std::string law_error(const std::string& family, const std::vector<double>& parameters) {
  PolicyParams p;
  p.bad_family = family;
  p.bad_parameters = parameters;
  try {
    (void)bad_law_of(p);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PolicyLaws, NameTheLawAndWhatItsFamilyNeeds) {
  EXPECT_THAT(law_error("gauss", {}),
              HasSubstr("policy.bad_family: 'gauss' is not one of: normal"));
  EXPECT_THAT(law_error("gev", {1, 2}), HasSubstr("policy.bad_parameters: 2 numbers, gev has k"));
  EXPECT_THAT(law_error("gamma", {}), HasSubstr("0 numbers, gamma has shape scale"));
  EXPECT_THAT(law_error("normal", {40}), HasSubstr("1 numbers, normal has mu sigma"));
  EXPECT_THAT(law_error("gamma", {5, -1}), HasSubstr("gamma.scale: -1 must be finite and above 0"));
  EXPECT_EQ(law_error("gev", {-0.5, 5, 30}), "no error") << "k and mu may have any sign";
}

TEST(PolicyLaws, BothWaysToTheStepOfANormalPairAgree) {
  PolicyParams p;
  p.good_mean = 75;
  p.good_sd = p.bad_sd = 6;
  p.bad_mean = 55;
  const Density truth = good_law_of(p);
  const StepLaw exact = step_law_of(p, truth);
  const StepLaw grid = step_law(Llr(DensityLlr(truth, bad_law_of(p), 0)), truth);
  for (const double y : {-10.0, -3.0, 0.0, 2.0, 5.0}) {
    EXPECT_NEAR(exact.above(y), grid.above(y), 2e-3) << y;
  }
}

/// A pair of normal laws with any spreads, so that the ratio turns on the scale, beyond it, or not.
struct Pair {
  Normal good;
  Normal bad;
  double clip;
};

Pair random_pair(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double good = uniform(50, 95);
  const double clip = random() % 2 == 0 ? 0 : uniform(1, 6);
  return {{good, uniform(3, 30)}, {good - uniform(2, 45), uniform(3, 30)}, clip};
}

/// Share of 20 000 qualities whose step exceeds `y`, against `law`, within 5 standard errors.
void expect_share(const StepLaw& law, const std::vector<double>& steps, double y) {
  const double n = static_cast<double>(steps.size());
  const auto above = std::count_if(steps.begin(), steps.end(), [y](double l) { return l > y; });
  const double p = law.above(y);
  EXPECT_GE(p, 0);
  EXPECT_LE(p, 1);
  EXPECT_NEAR(static_cast<double>(above) / n, p, 5 * std::sqrt(p * (1 - p) / n) + 2 / n) << y;
}

TEST(StepLawOf, AnyNormalPairIsHowOftenTheRatioExceedsABound) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const auto [good, bad, clip] = random_pair(random);
    const NormalLlr llr(good, bad, clip);
    const Normal truth =
        seed % 3 == 0 ? Normal{(good.mean + bad.mean) / 2, 12} : (seed % 3 == 1 ? good : bad);
    std::normal_distribution<double> quality(truth.mean, truth.sd);
    std::vector<double> steps(20000);
    for (double& step : steps) step = llr(quality(random));
    std::vector<double> reverse(steps);
    for (double& step : reverse) step = -step;
    for (const double y : {-5.5, -2.3, -0.4, 0.0, 0.7, 1.9, 4.1}) {
      expect_share(step_law(llr, clip, truth), steps, y);
      expect_share(reverse_step_law(llr, clip, truth), reverse, y);
    }
  }
}

TEST(StepLawOf, AClippedRatioHasItsEndsAtTheClip) {
  const NormalLlr llr(thesis_good, thesis_bad, 2);
  const StepLaw law = step_law(llr, 2, thesis_bad);
  EXPECT_EQ(law.above(2), 0) << "no step exceeds the clip";
  EXPECT_GT(law.above(1.999), 0.9);
  EXPECT_EQ(law.above(-2.001), 1);
  EXPECT_LT(law.above(-2), 1) << "some are held at it";
}

}  // namespace
}  // namespace tocsin::decision
