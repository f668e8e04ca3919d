// SPDX-License-Identifier: Apache-2.0
#include "held_normal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "decision/design/link_model.hpp"

namespace tocsin::decision {
namespace {

TEST(HeldNormal, HasADensityWithinAndProbabilitiesAtTheEnds) {
  const HeldNormal sut{90, 100};
  EXPECT_NEAR(sut.log_density(90), -std::log(10 * std::sqrt(2 * M_PI)), 1e-12);
  EXPECT_NEAR(std::exp(sut.log_density(100)), 0.158655, 1e-6);  // P(Z >= 1)
  EXPECT_NEAR(std::exp(sut.log_density(0)), std::erfc(9 * M_SQRT1_2) / 2, 1e-25);
  double mass = std::exp(sut.log_density(0)) + std::exp(sut.log_density(100));
  for (int i = 0; i < 1000; ++i) mass += 0.1 * std::exp(sut.log_density(0.1 * i + 0.05));
  EXPECT_NEAR(mass, 1, 1e-5);
}

TEST(HeldNormal, JumpsAtTheEnds) {
  const HeldNormal sut{90, 100};
  EXPECT_NEAR(sut.below(100), 0.841345, 1e-6);
  EXPECT_EQ(sut.up_to(100), 1);
  EXPECT_EQ(sut.below(0), 0);
  EXPECT_GT(sut.up_to(0), 0);
  EXPECT_EQ(sut.below(95), sut.up_to(95));
}

TEST(MeantBy, IsTheQualityItselfWithinTheScale) {
  const HeldNormal sut = meant_by(70, {80, 10});
  EXPECT_EQ(sut.mean, 70);
  EXPECT_EQ(sut.variance, 0);
}

TEST(MeantBy, IsTheMeanOfWhatLiesBeyondTheEnd) {
  std::mt19937_64 random(2);  // NOLINT: a fixed seed is the point
  for (const auto& [law, end] :
       {std::pair{Normal{95, 8}, 100.0}, {Normal{110, 8}, 100.0}, {Normal{3, 6}, 0.0}}) {
    std::normal_distribution<double> draw(law.mean, law.sd);
    double n = 0;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < 200000; ++i) {
      const double x = draw(random);
      if (std::clamp(x, 0.0, 100.0) != end) continue;
      n += 1;
      sum += x;
      squares += x * x;
    }
    const HeldNormal sut = meant_by(end, law);
    EXPECT_NEAR(sut.mean, sum / n, 0.1);
    EXPECT_NEAR(sut.variance, squares / n - sum / n * sum / n, 0.6);
  }
}

std::vector<double> draw(const LinkModel& model, std::size_t n) {
  const auto source = source_of(model, 5);
  std::vector<double> x(n);
  std::generate(x.begin(), x.end(), [&] { return source->next(); });
  return x;
}

const Ar1Link walk{thesis_good, 0.9};

TEST(Residuals, AreSoundForTheLinkThatIs) {
  const Residuals sut = residuals_of(walk, draw(walk, 5000));
  EXPECT_TRUE(sut.sound);
  EXPECT_LT(sut.ks, 0.02);
  EXPECT_LT(std::abs(sut.correlation), 0.045);
}

TEST(Residuals, ShowACorrelationThatIsNotInTheModel) {
  const Residuals sut = residuals_of(Ar1Link{thesis_good, 0.5}, draw(walk, 5000));
  EXPECT_FALSE(sut.sound);
  EXPECT_GT(std::abs(sut.correlation), 0.3);
}

TEST(Residuals, ShowALawThatIsNotInTheModel) {
  const Ar1Link narrow{{thesis_good.mean, 7}, 0.9};
  const Residuals sut = residuals_of(narrow, draw(walk, 5000));
  EXPECT_FALSE(sut.sound);
  EXPECT_GT(sut.ks, 0.05);
  EXPECT_LT(sut.log_likelihood, residuals_of(walk, draw(walk, 5000)).log_likelihood);
}

TEST(Residuals, CountParametersInTheBic) {
  const auto x = draw(walk, 1000);
  const Residuals sut = residuals_of(walk, x);
  EXPECT_NEAR(sut.bic, 3 * std::log(1000) - 2 * sut.log_likelihood, 1e-9);
}

TEST(Residuals, GoOverGaps) {
  auto x = draw(walk, 5000);
  for (std::size_t i = 100; i < 130; ++i) x[i] = std::nan("");
  EXPECT_TRUE(residuals_of(walk, x).sound);
  const TwoStateLink doors{{84, 7}, {66, 6}, 0.01, 0.05};
  auto y = draw(doors, 5000);
  for (std::size_t i = 100; i < 130; ++i) y[i] = std::nan("");
  EXPECT_TRUE(residuals_of(doors, y).sound);
}

TEST(FitLike, FitsTheSameKindAgain) {
  const auto x = draw(walk, 2000);
  EXPECT_NEAR(std::get<Ar1Link>(fit_like(walk, x)).correlation, 0.9, 0.03);
  const BlockLink blocks{draw(walk, 100), 20};
  const auto again = std::get<BlockLink>(fit_like(blocks, x));
  EXPECT_EQ(again.block, 20);
  EXPECT_EQ(again.recording, x);
  EXPECT_EQ(parameter_count(again), 0);
  EXPECT_EQ(parameter_count(walk), 3);
}

}  // namespace
}  // namespace tocsin::decision
