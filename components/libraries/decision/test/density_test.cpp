// SPDX-License-Identifier: Apache-2.0
#include "decision/density.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/extreme_value.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/inverse_gaussian.hpp>
#include <boost/math/distributions/laplace.hpp>
#include <boost/math/distributions/logistic.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/rayleigh.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

namespace bm = boost::math;

template <class Law>
void expect_same(const Density& sut, const Law& law) {
  for (const double x : {10.0, 36.5, 70.0, 81.0, 99.0}) {
    EXPECT_NEAR(sut.log_density(x), std::log(pdf(law, x)), 1e-9) << to_string(sut.family());
    EXPECT_NEAR(sut.cdf(x), cdf(law, x), 1e-12) << to_string(sut.family());
  }
}

TEST(Density, AgreesWithBoost) {
  expect_same({Family::normal, {80, 10, 0}}, bm::normal(80, 10));
  expect_same({Family::logistic, {80, 6, 0}}, bm::logistic(80, 6));
  expect_same({Family::laplace, {80, 8, 0}}, bm::laplace(80, 8));
  expect_same({Family::gumbel_max, {60, 30, 0}}, bm::extreme_value(60, 30));
  expect_same({Family::weibull, {84, 9, 0}}, bm::weibull(9, 84));
  expect_same({Family::gamma, {60, 1.3, 0}}, bm::gamma_distribution<>(60, 1.3));
  expect_same({Family::lognormal, {4.3, 0.4, 0}}, bm::lognormal(4.3, 0.4));
  expect_same({Family::inverse_gaussian, {80, 300, 0}}, bm::inverse_gaussian(80, 300));
  expect_same({Family::rayleigh, {50, 0, 0}}, bm::rayleigh(50));
  const bm::students_t t(4);
  const Density sut(Family::t_location_scale, {0, 1, 4});
  EXPECT_NEAR(sut.log_density(1.5), std::log(pdf(t, 1.5)), 1e-12);
  const Density beta(Family::beta, {6, 1.6, 0});
  EXPECT_NEAR(beta.log_density(70), std::log(pdf(bm::beta_distribution<>(6, 1.6), 0.7) / 100),
              1e-12);
}

TEST(Density, DoesNotUnderflowInTheTail) {
  EXPECT_NEAR(Density(Family::normal, {80, 1, 0}).log_density(0), -3200.918938533, 1e-6);
  EXPECT_NEAR(Density(Family::inverse_gaussian, {80, 5e5, 0}).cdf(80), 0.5, 0.02);
  EXPECT_TRUE(std::isfinite(Density(Family::rician, {80, 0.5, 0}).log_density(80)));
}

TEST(Density, MeetsItsLimitFamilies) {
  const Density normal(Family::normal, {80, 10, 0});
  const Density gumbel(Family::gumbel_max, {80, 10, 0});
  EXPECT_NEAR(Density(Family::t_location_scale, {80, 10, 1e9}).log_density(70),
              normal.log_density(70), 1e-8);
  EXPECT_NEAR(Density(Family::gev, {1e-10, 10, 80}).log_density(70), gumbel.log_density(70), 1e-8);
  EXPECT_NEAR(Density(Family::gev, {1e-7, 10, 80}).log_density(70), gumbel.log_density(70), 1e-6);
  const Density below(Family::rician, {80, std::sqrt(80 * 80 / 599.0), 0});
  const Density above(Family::rician, {80, std::sqrt(80 * 80 / 601.0), 0});
  EXPECT_NEAR(below.log_density(80), above.log_density(80), 0.01);
}

TEST(Density, HasNoMassOutsideItsSupport) {
  EXPECT_EQ(Density(Family::gamma, {60, 1.3, 0}).log_density(0), -INFINITY);
  EXPECT_EQ(Density(Family::gamma, {60, 1.3, 0}).cdf(-1), 0);
  EXPECT_EQ(Density(Family::beta, {6, 1.6, 0}).log_density(100), -INFINITY);
  EXPECT_EQ(Density(Family::beta, {6, 1.6, 0}).log_density(101), -INFINITY);
  EXPECT_EQ(Density(Family::truncated_normal, {80, 5, 0}).log_density(100.1), -INFINITY);
  EXPECT_EQ(Density(Family::gev, {-0.5, 10, 77}).log_density(98), -INFINITY);
  EXPECT_EQ(Density(Family::gev, {-0.5, 10, 77}).cdf(98), 1);
}

TEST(Density, IsFiniteAtTheEdgeOfAFlatBeta) {
  EXPECT_NEAR(Density(Family::beta, {1, 1, 0}).log_density(0), -std::log(100), 1e-12);
  EXPECT_NEAR(Density(Family::beta, {1, 1, 0}).log_density(100), -std::log(100), 1e-12);
}

TEST(Density, RejectsParametersThatAreNoLaw) {
  EXPECT_THROW(Density(Family::normal, {80, 0, 0}), ConfigError);
  EXPECT_THROW(Density(Family::normal, {NAN, 1, 0}), ConfigError);
  EXPECT_THROW(Density(Family::gamma, {-1, 1, 0}), ConfigError);
  EXPECT_NO_THROW(Density(Family::gev, {-0.4, 10, -5}));
  EXPECT_THROW(Density(Family::gev, {-0.4, -10, 5}), ConfigError);
}

TEST(Density, KnowsNoUnknownFamily) { EXPECT_EQ(family_from("cauchy"), std::nullopt); }

}  // namespace
}  // namespace tocsin::decision
