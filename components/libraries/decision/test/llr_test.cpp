// SPDX-License-Identifier: Apache-2.0
#include "decision/llr.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

Density normal(double mean, double sd) { return {Family::normal, {mean, sd, 0}}; }

TEST(DensityLlr, EqualsTheNormalRatioForNormalLaws) {
  const DensityLlr sut(normal(81.5669, 10.3309), normal(36.599, 7.3819), 0);
  const NormalLlr want;
  for (const double x : {30., 45., 55.9, 70., 81.}) EXPECT_NEAR(sut(x), want(x), 1e-9);
  EXPECT_TRUE(std::isnan(sut(NAN)));
}

TEST(DensityLlr, StaysFiniteWhereALawHasNoDensity) {
  const DensityLlr sut({Family::beta, {6, 1.6, 0}}, {Family::weibull, {40, 5, 0}}, 0);
  for (int x = -20; x <= 120; ++x) EXPECT_TRUE(std::isfinite(sut(x))) << x;
  EXPECT_LT(sut(100), 0);
  EXPECT_GT(sut(0), 0);
}

TEST(DensityLlr, IsBoundedByItsClip) {
  const DensityLlr sut(normal(80, 10), normal(40, 10), 4);
  EXPECT_EQ(sut(0), 4);
  EXPECT_EQ(sut(100), -4);
}

TEST(DensityLlr, RejectsLawsWithoutMassOnTheScaleOrInTheWrongOrder) {
  EXPECT_THROW(DensityLlr(normal(300, 5), normal(40, 5), 0), ConfigError);
  EXPECT_THROW(DensityLlr(normal(80, 5), normal(-300, 5), 0), ConfigError);
  EXPECT_THROW(DensityLlr(normal(40, 5), normal(80, 5), 0), ConfigError);
  EXPECT_THROW(DensityLlr(normal(80, 5), normal(40, 5), -1), ConfigError);
}

TEST(Llr, TakesEitherKind) {
  const Llr fast{NormalLlr{}};
  const Llr general{DensityLlr(normal(81.5669, 10.3309), normal(36.599, 7.3819), 0)};
  EXPECT_NEAR(fast(50), general(50), 1e-9);
}

}  // namespace
}  // namespace tocsin::decision
