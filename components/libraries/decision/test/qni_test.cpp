// SPDX-License-Identifier: Apache-2.0
#include "decision/qni.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

double value(const QniInput& input) { return QniModel(QniParams{}).evaluate(input).value; }

TEST(Qni, IsHundredOnAPerfectNetworkAndZeroOnADeadOne) {
  EXPECT_DOUBLE_EQ(value({0, -45, 70}), 100);
  EXPECT_DOUBLE_EQ(value({100, -99, 0}), 0);
}

TEST(Qni, WeighsTheThreeTerms) {
  EXPECT_DOUBLE_EQ(value({100, -45, 70}), 60);
  EXPECT_DOUBLE_EQ(value({0, -99, 70}), 70);
  EXPECT_DOUBLE_EQ(value({0, -45, 0}), 70);
  EXPECT_NEAR(value({50, -72, 35}), 50, 1e-12);
}

TEST(Qni, ClipsEveryTermBothSides) {
  EXPECT_DOUBLE_EQ(value({-5, -30, 100}), 100);
  EXPECT_DOUBLE_EQ(value({120, -110, -3}), 0);
  EXPECT_DOUBLE_EQ(value({0, -INFINITY, 70}), 70);
}

TEST(Qni, RisesWithSignalUpToTheBest) {
  EXPECT_LT(value({0, -46, 70}), value({0, -45, 70}));
  EXPECT_EQ(value({0, -45, 70}), value({0, -44, 70}));
}

TEST(Qni, LeavesMissingTermsOutAndRescales) {
  const Qni sut = QniModel(QniParams{}).evaluate({50, std::nullopt, NAN});
  EXPECT_DOUBLE_EQ(sut.value, 50);
  EXPECT_TRUE(sut.has_per);
  EXPECT_FALSE(sut.has_signal);
  EXPECT_FALSE(sut.has_quality);
  EXPECT_TRUE(sut.rescaled());
  EXPECT_DOUBLE_EQ(sut.weight_share, 0.4);
}

TEST(Qni, IsZeroWhenUnassociatedWithAllPacketsLost) {
  EXPECT_DOUBLE_EQ(value({100, std::nullopt, std::nullopt}), 0);
}

TEST(Qni, IsNotRescaledWhenComplete) {
  EXPECT_FALSE(QniModel(QniParams{}).evaluate({1, -60, 50}).rescaled());
}

TEST(Qni, IsNanWhenNothingWasMeasured) {
  const Qni sut = QniModel(QniParams{}).evaluate({});
  EXPECT_TRUE(std::isnan(sut.value));
  EXPECT_TRUE(sut.rescaled());
}

TEST(Qni, IsNanWhenOnlyTermsOfNoWeightWereMeasured) {
  EXPECT_TRUE(std::isnan(QniModel({0, 0.5, 0.5, -99, -45, 70}).evaluate({5, {}, {}}).value));
}

TEST(Qni, RejectsWeightsThatDoNotSumToOne) {
  EXPECT_THROW(QniModel({0.4, 0.3, 0.4, -99, -45, 70}), ConfigError);
  EXPECT_THROW(QniModel({0.4, 0.3, 0.2, -99, -45, 70}), ConfigError);
  EXPECT_NO_THROW(QniModel({0.2, 0.3, 0.5, -99, -45, 70}));
}

TEST(Qni, RejectsAnEmptySignalRange) {
  EXPECT_THROW(QniModel({0.4, 0.3, 0.3, -45, -45, 70}), ConfigError);
}

TEST(Qni, ReadsAMessageWhoseLinkQualityIsInPercentOfSeventy) {
  EXPECT_DOUBLE_EQ(value(qni_input(10, -72, 50)), 0.4 * 90 + 0.3 * 50 + 0.3 * 50);
  EXPECT_DOUBLE_EQ(value(qni_input(10, -72, NAN)), (0.4 * 90 + 0.3 * 50) / 0.7);
  EXPECT_TRUE(std::isnan(value(qni_input(NAN, NAN, NAN))));
}

}  // namespace
}  // namespace tocsin::decision
