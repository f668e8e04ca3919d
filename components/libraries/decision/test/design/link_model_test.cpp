// SPDX-License-Identifier: Apache-2.0
#include "decision/design/link_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

std::vector<double> draw(const LinkModel& model, std::size_t n, std::uint64_t seed = 1) {
  const auto source = source_of(model, seed);
  std::vector<double> x(n);
  std::generate(x.begin(), x.end(), [&] { return source->next(); });
  return x;
}

const Ar1Link walk{thesis_good, 0.9};
const TwoStateLink doors{{84, 7}, {66, 6}, 0.01, 0.05};

double mean_of(const std::vector<double>& x) {
  double sum = 0;
  for (const double one : x) sum += one;
  return sum / static_cast<double>(x.size());
}

TEST(LinkSource, HasTheMeanAndCorrelationOfItsModel) {
  const auto x = draw(Ar1Link{{50, 5}, 0.8}, 100000);
  EXPECT_NEAR(mean_of(x), 50, 0.3);
  double top = 0;
  double bottom = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    top += (x[i] - 50) * (x[i - 1] - 50);
    bottom += (x[i] - 50) * (x[i] - 50);
  }
  EXPECT_NEAR(top / bottom, 0.8, 0.01);
  EXPECT_NEAR(std::sqrt(bottom / 100000), 5, 0.15);
}

TEST(LinkSource, StaysWithinTheScaleAndRepeatsItselfForASeed) {
  for (const LinkModel& model : {LinkModel(walk), LinkModel(doors)}) {
    const auto x = draw(model, 5000, 7);
    EXPECT_LE(*std::max_element(x.begin(), x.end()), 100);
    EXPECT_GE(*std::min_element(x.begin(), x.end()), 0);
    EXPECT_EQ(x, draw(model, 5000, 7));
    EXPECT_NE(x, draw(model, 5000, 8));
  }
}

TEST(LinkSource, IsInEachStateAsLongAsTheModelSays) {
  EXPECT_NEAR(mean_of(draw(doors, 200000)), (84 * 5 + 66.0) / 6, 0.3);
}

TEST(LinkSource, StringsBlocksOfTheRecordingTogether) {
  std::vector<double> recording(100);
  for (std::size_t i = 0; i < 100; ++i) recording[i] = static_cast<double>(i);
  const auto x = draw(BlockLink{recording, 10}, 1000);
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (i % 10 == 0) continue;
    ASSERT_EQ(x[i], std::fmod(x[i - 1] + 1, 100)) << i;
  }
}

TEST(FitAr1, FindsTheLinkAlsoWhereQualityIsHeldAt100) {
  const auto x = draw(walk, 50000);
  EXPECT_GT(std::count(x.begin(), x.end(), 100.0), 1000);
  const Ar1Link sut = fit_ar1(x);
  EXPECT_NEAR(sut.law.mean, walk.law.mean, 0.5);  // 2.4 standard errors
  EXPECT_NEAR(sut.law.sd, walk.law.sd, 0.25);
  EXPECT_NEAR(sut.correlation, 0.9, 0.006);
}

TEST(FitAr1, TakesNanForAGap) {
  auto x = draw(walk, 20000);
  auto gaps = x;
  for (std::size_t i = 0; i < gaps.size(); i += 10) gaps[i] = nan;
  EXPECT_NEAR(fit_ar1(gaps).correlation, fit_ar1(x).correlation, 0.01);
}

TEST(FitAr1, RefusesWhatIsTooShort) {
  EXPECT_THROW((void)fit_ar1(draw(walk, 40)), ConfigError);
  EXPECT_THROW((void)fit_ar1(std::vector<double>(500, 100)), ConfigError);  // held throughout
}

TEST(FitTwoState, FindsBothStatesAndHowLongTheyLast) {
  const TwoStateLink sut = fit_two_state(draw(doors, 30000));
  EXPECT_NEAR(sut.high.mean, 84, 0.3);
  EXPECT_NEAR(sut.high.sd, 7, 0.3);
  EXPECT_NEAR(sut.low.mean, 66, 0.5);
  EXPECT_NEAR(sut.high_to_low, 0.01, 0.002);
  EXPECT_NEAR(sut.low_to_high, 0.05, 0.01);
  EXPECT_THROW((void)fit_two_state(draw(doors, 40)), ConfigError);
}

TEST(FitLink, ChoosesTheModelWhoseForecastsHold) {
  const LinkFit first = fit_link(draw(walk, 5000), 0);
  EXPECT_STREQ(name_of(first.model), "ar1");
  EXPECT_TRUE(first.ar1_residuals.sound);
  EXPECT_FALSE(first.two_state_residuals.sound);
  const LinkFit second = fit_link(draw(doors, 5000), 0);
  EXPECT_STREQ(name_of(second.model), "two_state");
  EXPECT_FALSE(second.ar1_residuals.sound);
}

TEST(FitLink, ResamplesTheRecordingWhenNoModelHolds) {
  std::vector<double> waves;
  for (int i = 0; i < 3000; ++i) waves.push_back(70 + 20 * std::sin(i * 0.1) + 0.1 * (i % 7));
  const LinkFit automatic = fit_link(waves, 0);
  ASSERT_STREQ(name_of(automatic.model), "blocks");
  EXPECT_GE(std::get<BlockLink>(automatic.model).block, 60);  // sin is at 1/e after 12 samples
  EXPECT_EQ(std::get<BlockLink>(fit_link(waves, 45).model).block, 45);
}

TEST(BlockFor, IsTenTimesAsLongAsTheCorrelation) {
  EXPECT_EQ(block_for(draw(Ar1Link{{50, 5}, 0}, 5000)), 10);
  EXPECT_NEAR(block_for(draw(Ar1Link{{50, 5}, 0.9}, 20000)), 100, 40);
  EXPECT_LE(block_for(draw(Ar1Link{{50, 5}, 0.99}, 500)), 50);
}

}  // namespace
}  // namespace tocsin::decision
