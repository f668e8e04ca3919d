// SPDX-License-Identifier: Apache-2.0
#include "metrics/user_cost.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace tocsin::experiment {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A link that nobody notices.
constexpr UserFigures perfect{0, 0, 0, 0, 100, 0, 0, 0};

TEST(UserCost, IsZeroForALinkThatNobodyNotices) { EXPECT_EQ(user_cost(perfect, CostWeights{}), 0); }

TEST(UserCost, TakesEachFigureByItsWeight) {
  CostWeights weights;
  UserFigures figures = perfect;
  figures.critical_late = 2;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 20);
  figures.critical_very_late = 1;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 40);
  figures.high_late = 1;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 44);
  figures.high_very_late = 1;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 52);
  figures.low_delivered = 90;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 62);
  figures.location_age_p99 = 0.5;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 72);
  figures.picture_p99 = 400;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 74);
  figures.airtime = 20;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 76);
  weights.airtime = 1;
  EXPECT_DOUBLE_EQ(user_cost(figures, weights), 94);
}

TEST(UserCost, ChargesNothingForWhatARunDoesNotHave) {
  UserFigures figures = perfect;
  figures.picture_p99 = none;
  figures.location_age_p99 = none;
  figures.low_delivered = none;
  EXPECT_EQ(user_cost(figures, CostWeights{}), 0);
}

TEST(UserCost, IsUnknownWhenNothingIsKnownOfClassCritical) {
  UserFigures figures = perfect;
  figures.critical_late = none;
  EXPECT_TRUE(std::isnan(user_cost(figures, CostWeights{})));
}

}  // namespace
}  // namespace tocsin::experiment
