// SPDX-License-Identifier: Apache-2.0
#include "decision/detectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "decision/llr.hpp"
#include "decision/research/mean_cusum.hpp"
#include "foundation/error.hpp"
#include "golden.hpp"

namespace tocsin::decision {
namespace {

TEST(MeanCusum, ReportsARiseAndAFall) {
  MeanCusum sut(0, 0.5, 4);
  EXPECT_EQ(sut.add(2), Shift::none);
  EXPECT_EQ(sut.add(3), Shift::none);  // 1.5 + 2.5 = 4 is not above 4
  EXPECT_EQ(sut.add(0.6), Shift::up);  // 4.1
  EXPECT_EQ(sut.run(), 3U);
  EXPECT_EQ(sut.up(), 0);
  EXPECT_EQ(sut.add(-4.6), Shift::down);
  EXPECT_EQ(sut.run(), 1U);
}

TEST(MeanCusum, StartsBothSidesAgainAfterAnAlarm) {
  MeanCusum sut(0, 0, 4);
  sut.add(-3);
  EXPECT_EQ(sut.down(), 3);
  EXPECT_EQ(sut.add(9), Shift::up);
  EXPECT_EQ(sut.down(), 0);
}

TEST(MeanCusum, IgnoresNan) {
  MeanCusum sut(0, 0.5, 4);
  sut.add(2);
  EXPECT_EQ(sut.add(NAN), Shift::none);
  EXPECT_EQ(sut.up(), 1.5);
}

TEST(MeanCusum, RejectsThresholdsThatMakeNoSense) {
  EXPECT_THROW(MeanCusum(0, -1, 4), ConfigError);
  EXPECT_THROW(MeanCusum(0, 0.5, 0), ConfigError);
}

TEST(ShiryaevRoberts, AddsOneAndMultiplies) {
  ShiryaevRoberts sut;
  EXPECT_NEAR(sut.add(std::log(2)), std::log(2), 1e-12);  // (1 + 0) 2
  EXPECT_NEAR(sut.add(std::log(3)), std::log(9), 1e-12);  // (1 + 2) 3
  EXPECT_EQ(sut.run(), 2U);
  EXPECT_TRUE(sut.alarm(std::log(9) - 1e-9));
  EXPECT_FALSE(sut.alarm(std::log(9) + 1e-9));
}

TEST(ShiryaevRoberts, NeitherOverflowsNorForgetsOnNan) {
  ShiryaevRoberts sut;
  for (int i = 0; i < 1000; ++i) sut.add(19);
  EXPECT_NEAR(sut.statistic(), 19000, 1);
  EXPECT_NEAR(sut.add(NAN), 19000, 1);
}

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
  const NormalLlr llr;
  ShiryaevRoberts roberts;
  Focus focus;
  Deviations numbers;
  for (std::size_t n = 0; n < t.rows; ++n) {
    const double x = t.columns["qni"][n];
    numbers.relative(roberts.add(llr(x)), t.columns["log_SR"][n], 1e-9);
    numbers.relative(focus.add(x), t.columns["focus_down"][n], 1e-9);
  }
  std::cout << name << ' ' << numbers.summary() << '\n';
  EXPECT_EQ(numbers.outside(), 0);
  EXPECT_EQ(numbers.compared(), 3000);
}

TEST(Detectors, FollowGoldenTrace1) { follow("trace1_iid.csv"); }
TEST(Detectors, FollowGoldenTrace2) { follow("trace2_ar_ramp.csv"); }

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

TEST(Cusum, TunedToAMildDegradationSeesWhatTheMainOneMisses) {
  const NormalLlr main;
  const NormalLlr mild(thesis_good, {65, thesis_good.sd});
  Cusum blind;
  Cusum sut;
  for (int i = 0; i < 20; ++i) {
    blind.add(main(62));
    sut.add(mild(62));
  }
  EXPECT_FALSE(blind.alarm(3.563));
  EXPECT_TRUE(sut.alarm(5.3468));
  EXPECT_EQ(sut.run(), 20U);
}

}  // namespace
}  // namespace tocsin::decision
