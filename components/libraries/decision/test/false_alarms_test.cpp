// SPDX-License-Identifier: Apache-2.0
#include "decision/false_alarms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "decision/run_length.hpp"

namespace tocsin::decision {
namespace {

const NormalLlr thesis;

/// Plays given qualities over and over; begins anew with the next of them.
class Replay final : public QualitySource {
 public:
  explicit Replay(std::vector<std::vector<double>> paths) : paths_(std::move(paths)) {}
  double next() override { return paths_[path_][at_++]; }
  void restart() override {
    path_ = path_ + 1 < paths_.size() ? path_ + 1 : 0;
    at_ = 0;
  }

 private:
  std::vector<std::vector<double>> paths_;
  std::size_t path_ = 1000;
  std::size_t at_ = 0;
};

/// The quality whose ratio of these laws is `l`: the ratio is straight in it.
const NormalLlr straight({60, 10}, {40, 10});
double quality(double l) { return 50 - 5 * l; }

TEST(FalseAlarmCurve, CountsTheTimeAtRiskOfAllPathsPerAlarm) {
  Replay source({{quality(2), quality(-1), quality(3), quality(-9)},
                 {quality(-1), quality(-1), quality(-1), quality(-1)}});
  CusumDetector cusum(straight);
  const FalseAlarmCurve sut(source, cusum, {2, 4});
  EXPECT_EQ(sut.run_length(1.9), 1 + 4);  // the first path alarms at once, the second never
  EXPECT_EQ(sut.alarms(1.9), 1);
  EXPECT_EQ(sut.run_length(3.9), 3 + 4);  // 2 - 1 + 3 after the third sample
  EXPECT_EQ(sut.alarms(4.1), 0);
  EXPECT_EQ(sut.run_length(4.1), 8 / 0.5);
}

TEST(FalseAlarmCurve, FindsTheThresholdOfARunLength) {
  const auto source = independent(thesis_good, 3);
  CusumDetector cusum(thesis);
  const FalseAlarmCurve sut(*source, cusum, {500, 3000});
  const double threshold = *sut.threshold_for(1000);
  EXPECT_NEAR(sut.run_length(threshold), 1000, 5);
  EXPECT_NEAR(threshold, 3.563, 0.25);
  EXPECT_GT(*sut.threshold_for(1500), threshold);
}

TEST(FalseAlarmCurve, AgreesWithTheMarkovChain) {
  const auto source = independent(thesis_good, 8);
  CusumDetector cusum(thesis);
  const FalseAlarmCurve sut(*source, cusum, {1500, 1500});
  for (const double alpha : {1.0, 2.0, 3.0}) {
    const double exact = mean_run_length(step_law(thesis, 0, thesis_good), alpha);
    EXPECT_NEAR(sut.run_length(alpha) / exact, 1, 0.08) << alpha;
  }
}

TEST(FalseAlarmCurve, HasNoThresholdForMoreFalseAlarmsThanTheSmallestGives) {
  const auto source = independent(thesis_good, 3);
  CusumDetector cusum(thesis);
  const FalseAlarmCurve sut(*source, cusum, {300, 500});
  EXPECT_FALSE(sut.threshold_for(100));  // 154 with the smallest
  EXPECT_TRUE(sut.threshold_for(250));
}

TEST(FalseAlarmCurve, SaysAtLeastTwiceAllTimeAtRiskWhereNoPathAlarmed) {
  const auto source = independent({95, 1}, 3);
  CusumDetector cusum(thesis);
  const FalseAlarmCurve sut(*source, cusum, {10, 100});
  EXPECT_EQ(sut.run_length(1), 2 * 10 * 100);
}

TEST(IndependentSource, HoldsWhatIsBeyondTheScaleAtItsEnd) {
  const auto sut = independent({99, 5}, 4);
  int held = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = sut->next();
    ASSERT_LE(x, 100);
    held += x == 100;
  }
  EXPECT_NEAR(held / 10000.0, 0.42, 0.02);
}

}  // namespace
}  // namespace tocsin::decision
