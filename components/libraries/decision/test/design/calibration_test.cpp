// SPDX-License-Identifier: Apache-2.0
// A short slice of test/bench/decision's calibration_coverage.
#include "decision/design/calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

const auto cusum = std::make_shared<CusumDetector>(NormalLlr());

CalibrationRequest request(const LinkModel& link, std::size_t n, double samples,
                           std::uint64_t seed = 1) {
  const auto source = source_of(link, seed);
  CalibrationRequest result{{}, cusum, samples};
  for (std::size_t i = 0; i < n; ++i) result.qualities.push_back(source->next());
  result.replicates = 20;
  result.paths = 150;
  return result;
}

/// How many of the intervals hold the true run length, which thresholds have that are calibrated on
/// 12 recordings of 600 samples for 300.
int covered(const LinkModel& link) {
  const auto source = source_of(link, 99);
  const FalseAlarmCurve truth(*source, *cusum, {1000, 900});
  int count = 0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Calibration sut = calibrate(request(link, 600, 300, 100 + i));
    const double real = truth.run_length(sut.threshold);
    count += real >= sut.true_samples.low && real <= sut.true_samples.high;
  }
  return count;
}

TEST(Calibrate, HoldsTheTruthInItsIntervalOnACorrelatedLink) {
  EXPECT_GE(covered(Ar1Link{thesis_good, 0.9}), 10);  // of 12
}

TEST(Calibrate, HoldsTheTruthInItsIntervalOnALinkOfTwoStates) {
  EXPECT_GE(covered(TwoStateLink{{84, 7}, {66, 7}, 0.01, 0.05}), 10);
}

TEST(Calibrate, AgreesWithTheExactThresholdOnIndependentData) {
  const Calibration sut = calibrate(request(Ar1Link{thesis_good, 0}, 15000, 1000));
  EXPECT_NEAR(sut.threshold, 3.563, 0.25);
  EXPECT_LT(sut.true_samples.high / sut.true_samples.low, 2.5);
  EXPECT_NEAR(sut.alarms_seen, 15, 10);
  EXPECT_FALSE(sut.extrapolated());
}

TEST(Calibrate, AsksForALongerRecordingTheStrongerTheCorrelation) {
  double before = 0;
  for (const double correlation : {0.0, 0.8, 0.95}) {
    const Calibration sut = calibrate(request(Ar1Link{thesis_good, correlation}, 4000, 1500));
    EXPECT_GT(sut.needed_samples, 1.3 * before) << correlation;
    before = sut.needed_samples;
  }
}

TEST(Calibrate, SaysThatARecordingOfLessThanTenFalseAlarmTimesIsExtrapolated) {
  EXPECT_TRUE(calibrate(request(Ar1Link{thesis_good, 0}, 3999, 400)).extrapolated());
  EXPECT_FALSE(calibrate(request(Ar1Link{thesis_good, 0}, 4000, 400)).extrapolated());
}

TEST(Calibrate, IsTheSameForTheSameSeed) {
  const auto wish = request(Ar1Link{thesis_good, 0.5}, 1000, 200);
  EXPECT_EQ(calibrate(wish).threshold, calibrate(wish).threshold);
  EXPECT_EQ(calibrate(wish).true_samples.low, calibrate(wish).true_samples.low);
}

TEST(Calibrate, SaysWhenTheRecordBoundsNoThreshold) {
  const Calibration sut = calibrate(request(Ar1Link{{90, 3}, 0.5}, 1000, 100));
  EXPECT_TRUE(sut.any_threshold);
  EXPECT_GT(sut.true_samples.low, 100);
  EXPECT_GT(sut.true_samples.high, sut.true_samples.low);
}

TEST(Calibrate, DoesNotCountGapsAsRecorded) {
  CalibrationRequest wish = request(Ar1Link{thesis_good, 0.5}, 1000, 200);
  wish.qualities[500] = nan;
  EXPECT_EQ(calibrate(wish).held_samples, 999);
}

TEST(Calibrate, RefusesRecordsThatAreNone) {
  EXPECT_THROW((void)calibrate({{80, 82, 81}, cusum, 100}), ConfigError);
}

}  // namespace
}  // namespace tocsin::decision
