// SPDX-License-Identifier: Apache-2.0
#include "decision/joint_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "decision/cusum.hpp"
#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

using ::testing::HasSubstr;

/// Scores that are the readings themselves, nearly: signal of -60 +-2 dBm, falls of 1 and 2.
JointIndexParams two_readings(double correlation) {
  JointIndexParams params;
  params.joint_center = {0, std::log1p(10), 0, 0, 60};
  params.joint_scale = {1, 0.5, 1, 1, 2};
  params.joint_fall = {0, 1, 0, 0, 2};
  params.joint_correlation = {0, 0, 0, 0, 0, 0, correlation, 0, 0, 0};
  return params;
}

/// A round-trip time and a signal that are so many standard deviations worse than usual.
JointIndexInput worse(double rtt, double signal) {
  return {{}, std::expm1(std::log1p(10) + 0.5 * rtt), {}, {}, -60 - 2 * signal};
}

std::string error_of(const JointIndexParams& params) {
  try {
    (void)JointIndex(params);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(JointIndex, IsEightyOnAUsualLinkAndTenLessForEachStandardDeviation) {
  const JointIndex sut(two_readings(0));
  EXPECT_NEAR(sut.evaluate(worse(0, 0)), 80, 1e-9);
  EXPECT_NEAR(sut.distance(), std::sqrt(5), 1e-12);
  EXPECT_NEAR(sut.evaluate(worse(1, 2)), 80 - 10 * sut.distance(), 1e-9);
}

TEST(JointIndex, IsTheJointLogLikelihoodRatioOfNormalScores) {
  constexpr double r = 0.6;
  const JointIndex sut(two_readings(r));
  const double d = sut.distance();
  // l = fall' R^-1 (z - fall/2), written out for two readings
  const double w_rtt = (1 - r * 2) / (1 - r * r);
  const double w_signal = (2 - r * 1) / (1 - r * r);
  ASSERT_LT(w_rtt, 0);  // so this reading is left out, and the signal alone remains
  ASSERT_GT(w_signal, 0);
  EXPECT_NEAR(d, 2, 1e-12);
  EXPECT_NEAR(sut.evaluate(worse(5, 1)), 70, 1e-9);
  constexpr double weak = 0.3;
  const JointIndex both(two_readings(weak));
  const double a = (1 - weak * 2) / (1 - weak * weak);
  const double b = (2 - weak * 1) / (1 - weak * weak);
  for (const auto& [rtt, signal] : {std::pair(0.5, -1.0), std::pair(2.0, 0.3)}) {
    const double expected = a * (rtt - 0.5) + b * (signal - 1);
    const double y = (80 - both.evaluate(worse(rtt, signal))) / 10;
    EXPECT_NEAR(both.distance() * y - both.distance() * both.distance() / 2, expected, 1e-9);
  }
}

TEST(JointIndex, MakesOfACusumOfItselfTheCusumOfTheJointRatio) {
  constexpr double r = 0.3;
  const JointIndex sut(two_readings(r));
  const double d = sut.distance();
  const NormalLlr llr({80, 10}, {80 - 10 * d, 10});
  const double a = (1 - r * 2) / (1 - r * r);
  const double b = (2 - r * 1) / (1 - r * r);
  Cusum cusum;
  double joint = 0;
  for (int i = 0; i < 200; ++i) {
    const double rtt = std::sin(i) + (i > 150 ? 1 : 0);
    const double signal = std::cos(1.7 * i) + (i > 150 ? 2 : 0);
    joint = std::max(0.0, joint + a * (rtt - 0.5) + b * (signal - 1));
    EXPECT_NEAR(cusum.add(llr(sut.evaluate(worse(rtt, signal)))), joint, 1e-9) << i;
  }
  EXPECT_GT(joint, 50);
}

TEST(JointIndex, NeverRisesWhenAReadingGetsWorse) {
  JointIndexParams params;
  params.joint_fall = {1, 0.3, 2, 0.4, 0.1};
  params.joint_scale = {0.2, 0.5, 0.2, 0.1, 4};
  params.joint_center = {0.1, 2, 0.2, 0.3, 60};
  params.joint_correlation = {0.7, 0.6, 0.2, 0.3, 0.5, 0.1, 0.4, 0.1, 0.2, 0.3};
  const JointIndex sut(params);
  const double quality = sut.evaluate({2, 8, 5, 10, -62});
  for (double step = 0; step < 30; step += 1) {
    EXPECT_LE(sut.evaluate({2 + step, 8, 5, 10, -62}), quality + 1e-9);
    EXPECT_LE(sut.evaluate({2, 8 + 10 * step, 5, 10, -62}), quality + 1e-9);
    EXPECT_LE(sut.evaluate({2, 8, 5 + step, 10, -62}), quality + 1e-9);
    EXPECT_LE(sut.evaluate({2, 8, 5, 10 + step, -62}), quality + 1e-9);
    EXPECT_LE(sut.evaluate({2, 8, 5, 10, -62 - step}), quality + 1e-9);
  }
}

TEST(JointIndex, TakesTheWorstOfSeveralKindsOfBadLinks) {
  JointIndexParams params = two_readings(0);
  params.joint_fall = {0, 1, 0, 0, 0, 0, 0, 0, 0, 2};  // slow; weak
  const JointIndex sut(params);
  EXPECT_NEAR(sut.evaluate(worse(3, 1)), 50, 1e-9);
  EXPECT_NEAR(sut.evaluate(worse(1, 3)), 50, 1e-9);
  EXPECT_NEAR(sut.distance(), 1, 1e-12);
  JointIndexInput slow = worse(3, 0);
  slow.signal_dbm = {};
  EXPECT_NEAR(sut.evaluate(slow), 50, 1e-9);  // what tells of the other kind is not told
}

TEST(JointIndex, LeavesOutWhatIsNotTold) {
  const JointIndex sut(two_readings(0.3));
  JointIndexInput input = worse(1, 1);
  input.signal_dbm = {};
  EXPECT_NEAR(sut.evaluate(input), 70, 1e-9);  // the round-trip time alone
  input.signal_dbm = nan;
  EXPECT_NEAR(sut.evaluate(input), 70, 1e-9);
  EXPECT_TRUE(std::isnan(sut.evaluate({})));
  EXPECT_TRUE(
      std::isnan(sut.evaluate({5, {}, {}, {}})));  // loss says nothing here: it does not fall
}

TEST(JointIndex, StaysOnItsScaleWhateverComes) {
  const JointIndex sut{JointIndexParams{}};
  for (const double x : {-1e300, -1.0, 0.0, 50.0, 100.0, 1e300, infinity, -infinity}) {
    const double quality = sut.evaluate({x, x, x, x, x});
    EXPECT_GE(quality, 0) << x;
    EXPECT_LE(quality, 100) << x;
  }
  EXPECT_EQ(sut.evaluate({100, 1e6, 100, 100, -120}), 0);
}

TEST(JointIndex, OneReadingMovesItByAtMostSixStandardDeviations) {
  const JointIndex sut(two_readings(0));
  const double b = 2 / std::sqrt(5);
  EXPECT_NEAR(sut.evaluate(worse(0, 6)), 80 - 10 * 6 * b, 1e-9);
  EXPECT_NEAR(sut.evaluate(worse(0, 600)), 80 - 10 * 6 * b, 1e-9);
}

TEST(JointIndex, RejectsParametersThatAreNone) {
  JointIndexParams params = two_readings(0);
  params.joint_center.pop_back();
  EXPECT_THAT(error_of(params), HasSubstr("quality.joint_center: 4 numbers, must be 5"));
  params = two_readings(0);
  params.joint_correlation = {0.9};
  EXPECT_THAT(error_of(params), HasSubstr("joint_correlation: 1 numbers, must be 10"));
  params = two_readings(0);
  params.joint_fall.push_back(1);
  EXPECT_THAT(error_of(params), HasSubstr("joint_fall: 6 numbers, must be 5"));
  params = two_readings(0);
  params.joint_correlation = {0.9, 0.9, 0, 0, -0.9, 0, 0, 0, 0, 0};
  EXPECT_THAT(error_of(params), HasSubstr("not positive definite"));
  params.joint_correlation[4] = 0.9;
  EXPECT_EQ(error_of(params), "no error");
  params.joint_fall = {0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_THAT(error_of(params), HasSubstr("a kind of bad link in which no reading falls"));
}

}  // namespace
}  // namespace tocsin::decision
