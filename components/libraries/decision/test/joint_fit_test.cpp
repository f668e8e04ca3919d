// SPDX-License-Identifier: Apache-2.0
#include "decision/joint_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

/// Round-trip time and signal with this correlation of their scores, `fall` standard deviations
/// worse.
std::vector<JointIndexInput> link(int samples, double correlation, double fall, unsigned seed) {
  std::mt19937_64 random(seed);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> normal(0, 1);
  std::vector<JointIndexInput> all;
  for (int i = 0; i < samples; ++i) {
    const double a = normal(random);
    const double b = correlation * a + std::sqrt(1 - correlation * correlation) * normal(random);
    all.push_back({{}, std::expm1(3 + 0.4 * (a + fall)), {}, {}, -60 - 3 * (b + fall)});
  }
  return all;
}

TEST(JointFit, FindsWhatTheLinkWasMadeOf) {
  const JointFit sut = fit_joint(link(5000, 0.5, 0, 1), {link(5000, 0.5, 2, 2)});
  EXPECT_NEAR(sut.params.joint_center[1], 3, 0.02);
  EXPECT_NEAR(sut.params.joint_scale[4], 3, 0.1);
  EXPECT_NEAR(sut.params.joint_fall[1], 2, 0.1);
  EXPECT_NEAR(sut.params.joint_fall[4], 2, 0.1);
  EXPECT_NEAR(sut.params.joint_correlation[6], 0.5, 0.04);
  EXPECT_LT(sut.shrinkage, 0.05);
  EXPECT_NEAR(sut.good.mean, 80, 0.5);
  EXPECT_NEAR(sut.good.sd, 10, 0.5);
  EXPECT_NEAR(sut.bad.mean, 80 - 10 * JointIndex(sut.params).distance(), 1);
}

TEST(JointFit, HasAFallForEachKindOfBadLink) {
  auto slow = link(500, 0, 0, 2);
  for (JointIndexInput& one : slow) one.rtt_ms = *one.rtt_ms * 5;
  const JointFit sut = fit_joint(link(500, 0, 0, 1), {slow, link(500, 0, 2, 3)});
  ASSERT_EQ(sut.params.joint_fall.size(), 2 * joint_readings);
  EXPECT_GT(sut.params.joint_fall[1], 3);
  EXPECT_LT(sut.params.joint_fall[4], 0.3);
  EXPECT_NEAR(sut.params.joint_fall[5 + 4], 2, 0.2);
  EXPECT_LT(sut.good.mean, 80);  // the worse of two
  EXPECT_LT(sut.bad.mean, 60);
}

TEST(JointFit, TakesNoPartOfAReadingThatIsNotTold) {
  const JointFit sut = fit_joint(link(500, 0, 0, 1), {link(500, 0, 2, 2)});
  EXPECT_EQ(sut.params.joint_fall[0], 0);
  EXPECT_EQ(sut.params.joint_fall[2], 0);
  EXPECT_EQ(sut.params.joint_correlation[0], 0);
}

TEST(JointFit, TakesNoPartOfAReadingThatIsBetterInTheBadLink) {
  auto bad = link(500, 0, 2, 2);
  for (JointIndexInput& one : bad) one.rtt_ms = 1;
  const JointFit sut = fit_joint(link(500, 0, 0, 1), {bad});
  EXPECT_EQ(sut.params.joint_fall[1], 0);
  EXPECT_GT(sut.params.joint_fall[4], 1);
}

TEST(JointFit, ScalesAReadingByItsHeavyTail) {
  auto good = link(1000, 0, 0, 1);
  for (std::size_t i = 0; i < good.size(); i += 40) good[i].rtt_ms = 2000;  // one sample in forty
  const JointFit sut = fit_joint(good, {link(1000, 0, 5, 2)});
  const double tail = (std::log1p(2000) - sut.params.joint_center[1]) / 2.326;
  EXPECT_NEAR(sut.params.joint_scale[1], tail,
              0.01);  // its standard deviation is less than half of it
  EXPECT_NEAR(sut.params.joint_scale[4], 3, 0.4);
}

TEST(JointFit, DoesNotThinkAReadingThatNeverMovedExact) {
  auto good = link(500, 0, 0, 1);
  auto bad = link(500, 0, 2, 2);
  for (JointIndexInput& one : good) one.per_percent = 0;
  for (JointIndexInput& one : bad) one.per_percent = 5;
  const JointFit sut = fit_joint(good, {bad});
  EXPECT_EQ(sut.params.joint_scale[0], 0.05);
  EXPECT_NEAR(sut.params.joint_fall[0], std::asin(std::sqrt(0.05)) / 0.05, 1e-9);
}

TEST(JointFit, ShrinksCorrelationsOfFewSamples) {
  const JointFit few = fit_joint(link(60, 0.2, 0, 1), {link(60, 0.2, 2, 2)});
  const JointFit many = fit_joint(link(5000, 0.2, 0, 1), {link(5000, 0.2, 2, 2)});
  EXPECT_GT(few.shrinkage, many.shrinkage);
  EXPECT_LT(many.shrinkage, 0.1);
}

TEST(JointFit, RejectsLinksThatTellNothingOrDoNotFall) {
  EXPECT_THROW((void)fit_joint({}, {{}}), ConfigError);
  const auto good = link(100, 0, 0, 1);
  EXPECT_THROW((void)fit_joint(good, {good}), ConfigError);
  EXPECT_THROW((void)fit_joint(good, {link(20, 0, 2, 2)}), ConfigError);
}

}  // namespace
}  // namespace tocsin::decision
