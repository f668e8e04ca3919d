// SPDX-License-Identifier: Apache-2.0
// What holds for every family with any parameters that are a law, and for ratios of any two.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "decision/density.hpp"
#include "decision/llr.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

class RandomLaws {
 public:
  explicit RandomLaws(unsigned seed) : random_(seed) {}
  /// A law around the scale of a quality index.
  Density next(Family family) {
    const double place = between(15, 85);
    const double width = between(3, 15);
    switch (family) {
      case Family::t_location_scale:
        return {family, {place, width, between(1.5, 30)}};
      case Family::gev:
        return {family, {between(-0.5, 0.5), width, place}};
      case Family::weibull:
        return {family, {place, between(1.2, 12), 0}};
      case Family::gamma:
        return {family, {between(2, 80), between(0.3, 3), 0}};
      case Family::lognormal:
      case Family::loglogistic:
        return {family, {std::log(place), between(0.05, 0.6), 0}};
      case Family::inverse_gaussian:
        return {family, {place, between(50, 5000), 0}};
      case Family::nakagami:
        return {family, {between(0.6, 20), place * place, 0}};
      case Family::birnbaum_saunders:
        return {family, {place, between(0.05, 0.8), 0}};
      case Family::beta:
        return {family, {between(1.05, 12), between(1.05, 12), 0}};
      default:
        return {family, {place, width, 0}};
    }
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::minstd_rand random_;
};

/// The integral of a density from `from` to `to` by Simpson's rule.
double mass(const Density& density, double from, double to) {
  constexpr int steps = 1000;
  const double h = (to - from) / steps;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const int weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::exp(density.log_density(from + i * h));
  }
  return sum * h / 3;
}

class EveryFamily : public ::testing::TestWithParam<int> {
 protected:
  const Family family_ = all_families()[static_cast<std::size_t>(GetParam())];
  RandomLaws laws_{static_cast<unsigned>(GetParam()) + 1};
};

TEST_P(EveryFamily, HasTheMassThatItsDistributionSays) {
  for (int i = 0; i < 10; ++i) {
    const Density sut = laws_.next(family_);
    const double from = laws_.between(5, 45);
    const double to = laws_.between(50, 95);
    ASSERT_NEAR(mass(sut, from, to), sut.cdf(to) - sut.cdf(from), 1e-5)
        << to_string(family_) << ' ' << sut.parameters()[0] << ' ' << sut.parameters()[1] << ' '
        << sut.parameters()[2];
  }
}

TEST_P(EveryFamily, ItsDistributionIsAProbabilityThatNeverFalls) {
  for (int i = 0; i < 10; ++i) {
    const Density sut = laws_.next(family_);
    double last = 0;
    for (double x = -200; x <= 400; x += 2.5) {
      const double p = sut.cdf(x);
      ASSERT_GE(p, last - 1e-12) << to_string(family_) << " at " << x;
      ASSERT_LE(p, 1 + 1e-12);
      last = p;
    }
    EXPECT_NEAR(sut.cdf(-1e6), 0, 1e-3);
    EXPECT_NEAR(sut.cdf(1e6), 1, 1e-3);
  }
}

TEST_P(EveryFamily, IsSilentAboutWhatIsNoNumberAndNeverNanOtherwise) {
  for (int i = 0; i < 10; ++i) {
    const Density sut = laws_.next(family_);
    EXPECT_TRUE(std::isnan(sut.log_density(std::nan(""))));
    for (const double x : {-1e9, -1.0, 0.0, 1e-300, 50.0, 100.0, 1e9}) {
      ASSERT_FALSE(std::isnan(sut.log_density(x))) << to_string(family_) << " at " << x;
      ASSERT_FALSE(std::isnan(sut.cdf(x))) << to_string(family_) << " at " << x;
    }
  }
}

TEST_P(EveryFamily, HasANameThatIsFoundAgain) {
  EXPECT_EQ(family_from(to_string(family_)), family_);
  EXPECT_GE(parameter_names(family_).size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily, ::testing::Range(0, family_count));

TEST(DensityLlr, OfAnyTwoLawsIsBoundedAndFinite) {
  RandomLaws laws(7);
  int pairs = 0;
  for (int i = 0; i < 3000 && pairs < 100; ++i) {
    const auto family = [&] {
      return all_families()[static_cast<std::size_t>(laws.between(0, family_count))];
    };
    const double clip = i % 2 == 0 ? 0 : laws.between(0.5, 5);
    try {
      const DensityLlr sut(laws.next(family()), laws.next(family()), clip);
      ++pairs;
      EXPECT_TRUE(std::isnan(sut(std::nan(""))));
      for (double x = -20; x <= 120; x += 0.5) {
        const double l = sut(x);
        ASSERT_TRUE(std::isfinite(l)) << x;
        ASSERT_LE(std::abs(l), clip > 0 ? clip : 2 * -DensityLlr::floor);
      }
    } catch (const ConfigError&) {
      continue;  // the good law was not the better one
    }
  }
  EXPECT_EQ(pairs, 100);
}

}  // namespace
}  // namespace tocsin::decision
