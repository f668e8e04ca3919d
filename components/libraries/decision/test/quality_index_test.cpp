// SPDX-License-Identifier: Apache-2.0
#include "decision/quality_index.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

QualityIndexParams channel() {
  QualityIndexParams params;
  params.quality_index = "channel";
  return params;
}

TEST(QualityIndex, IsTheThesisOneByDefault) {
  const QualityIndex sut{QualityIndexParams{}};
  EXPECT_DOUBLE_EQ(sut.evaluate({10, -72, 50, 90, 90}), 0.4 * 90 + 0.3 * 50 + 0.3 * 50);
}

TEST(QualityIndex, CountsTheChannelInPlaceOfTheLinkQuality) {
  const QualityIndex sut{channel()};
  EXPECT_DOUBLE_EQ(sut.evaluate({10, -72, 50, 0, 20}), 0.4 * 90 + 0.3 * 50 + 0.3 * 80);
  // 60 % of the frames were retries: 1.5 for each frame, half of retries_worst
  EXPECT_NEAR(sut.evaluate({10, -72, 50, 60, 20}), 0.4 * 90 + 0.3 * 50 + 0.3 * 50, 1e-9);
  EXPECT_DOUBLE_EQ(sut.evaluate({10, -72, 50, 100, 20}), 0.4 * 90 + 0.3 * 50);
}

TEST(QualityIndex, SeesCongestionThatTheThesisIndexDoesNot) {
  const QualityMeasurement idle{0, -60, 70, 5, 10};
  const QualityMeasurement busy{0, -60, 70, 5, 95};
  const QualityIndex thesis{QualityIndexParams{}};
  const QualityIndex sut{channel()};
  EXPECT_EQ(thesis.evaluate(busy), thesis.evaluate(idle));
  EXPECT_LT(sut.evaluate(busy), sut.evaluate(idle) - 20);
}

TEST(QualityIndex, WeighsAllReadingsTogetherWhenThatIsChosen) {
  QualityIndexParams params;
  params.quality_index = "joint";
  const QualityIndex sut{params};
  const JointIndex same{params.joint};
  EXPECT_EQ(sut.evaluate({10, -72, 50, 30, 20, 12}), same.evaluate({10, 12, 30, 20, -72}));
  EXPECT_GT(sut.evaluate({0, -60, {}, 2, {}, 3}), sut.evaluate({0, -60, {}, 2, {}, 60}));
  params.joint.joint_fall.clear();
  EXPECT_THROW(QualityIndex{params}, ConfigError);
  params.quality_index = "thesis";
  EXPECT_NO_THROW(QualityIndex{params});
}

TEST(QualityIndex, LeavesOutWhatTheHardwareDoesNotTell) {
  const QualityIndex sut{channel()};
  EXPECT_DOUBLE_EQ(sut.evaluate({10, -72, {}, {}, {}}), (0.4 * 90 + 0.3 * 50) / 0.7);
  EXPECT_TRUE(std::isnan(sut.evaluate({})));
  EXPECT_TRUE(std::isnan(sut.evaluate({nan, nan, 50, nan, nan})));
}

TEST(QualityIndex, ChecksTheWeightsOfTheChosenIndexOnly) {
  QualityIndexParams params = channel();
  params.thesis.weight_quality = 0.9;
  EXPECT_NO_THROW(QualityIndex{params});
  params.weight_channel = 0.9;
  EXPECT_THROW(QualityIndex{params}, ConfigError);
  params.quality_index = "thesis";
  EXPECT_THROW(QualityIndex{params}, ConfigError);
}

TEST(QualityIndex, ScalesTheLinkQualityByWhatScores100) {
  QualityIndexParams params;
  params.thesis.quality_best = 35;  // 50 % of 70
  EXPECT_DOUBLE_EQ(QualityIndex{params}.evaluate({10, -72, 50, {}, {}}), 36 + 15 + 30);
}

}  // namespace
}  // namespace tocsin::decision
