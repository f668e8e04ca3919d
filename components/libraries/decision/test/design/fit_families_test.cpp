// SPDX-License-Identifier: Apache-2.0
// Each family finds its own law again in data that has exactly its quantiles.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "decision/design/fit.hpp"

namespace tocsin::decision {
namespace {

/// As recordings have them: mass on the scale, hardly any at its ends.
const std::vector<Density>& laws() {
  static const std::vector<Density> all{{Family::normal, {70, 8, 0}},
                                        {Family::logistic, {70, 4, 0}},
                                        {Family::t_location_scale, {65, 6, 5}},
                                        {Family::laplace, {65, 5, 0}},
                                        {Family::gumbel_max, {50, 7, 0}},
                                        {Family::gumbel_min, {75, 6, 0}},
                                        {Family::gev, {-0.3, 10, 60}},
                                        {Family::weibull, {75, 7, 0}},
                                        {Family::gamma, {40, 1.6, 0}},
                                        {Family::lognormal, {4, 0.15, 0}},
                                        {Family::loglogistic, {4, 0.07, 0}},
                                        {Family::inverse_gaussian, {60, 3000, 0}},
                                        {Family::rayleigh, {27, 0, 0}},
                                        {Family::rician, {60, 9, 0}},
                                        {Family::nakagami, {6, 3500, 0}},
                                        {Family::exponential, {14, 0, 0}},
                                        {Family::birnbaum_saunders, {60, 0.15, 0}},
                                        {Family::beta, {7, 3, 0}},
                                        {Family::truncated_normal, {92, 15, 0}}};
  return all;
}

double quantile(const Density& law, double share) {
  double low = 0;
  double high = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (law.cdf(middle) < share ? low : high) = middle;
  }
  return low;
}

class FitOfItsOwnLaw : public ::testing::TestWithParam<int> {
 protected:
  static constexpr int samples = 300;
  const Density& law_ = laws()[static_cast<std::size_t>(GetParam())];
  const FitData data_ = prepare_fit(
      [this] {
        std::vector<double> values;
        for (int i = 0; i < samples; ++i) values.push_back(quantile(law_, (i + 0.5) / samples));
        return values;
      }(),
      to_string(law_.family()));
};

TEST_P(FitOfItsOwnLaw, FindsItsDistributionAgain) {
  ASSERT_EQ(static_cast<int>(law_.family()), GetParam()) << "each family once";
  const Fit sut = fit(law_.family(), data_);
  for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
    EXPECT_NEAR(sut.density.cdf(quantile(law_, share)), share, 0.015);
  }
  EXPECT_LT(sut.ks, 0.04) << "of the exponential law 3.5 % are held at 0.5";
}

TEST_P(FitOfItsOwnLaw, IsAtLeastAsLikelyAsTheLawThatTheDataAreOf) {
  double likelihood = 0;
  for (const double x : data_.sorted) likelihood += law_.log_density(x);
  EXPECT_GE(fit(law_.family(), data_).log_likelihood, likelihood - 1e-6);
}

/// A recording beside the access point: every family has to be fitted, to say which one is best.
TEST(FitOfHardlyAnySpread, HasAllFamiliesWithNumbersThatAreSome) {
  for (const double spread : {1e-1, 1e-3, 1e-5, 1e-7}) {
    SCOPED_TRACE("spread " + std::to_string(spread * 1e7) + "e-7");
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) values.push_back(90 + spread * std::sin(i * 1.7));
    const FitData data = prepare_fit(values, "still");
    for (const Fit& one : fit_all(data)) {
      EXPECT_GE(one.ks, 0) << to_string(one.density.family());
      EXPECT_LE(one.ks, 1) << to_string(one.density.family());
      EXPECT_FALSE(std::isnan(one.bic)) << to_string(one.density.family());
    }
  }
}

TEST(RicianDensity, IsContinuousWhereItsDistributionIsTakenForNormal) {
  for (const double z : {-3.0, -1.0, 0.0, 0.5, 2.0}) {
    const double below = Density(Family::rician, {80, 80 / 0.99e4, 0}).cdf(80 + z * 80 / 0.99e4);
    const double above = Density(Family::rician, {80, 80 / 1.01e4, 0}).cdf(80 + z * 80 / 1.01e4);
    EXPECT_NEAR(below, above, 1e-6) << z;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, FitOfItsOwnLaw, ::testing::Range(0, family_count),
                         [](const auto& one) {
                           return std::string(
                               to_string(all_families()[static_cast<std::size_t>(one.param)]));
                         });

}  // namespace
}  // namespace tocsin::decision
