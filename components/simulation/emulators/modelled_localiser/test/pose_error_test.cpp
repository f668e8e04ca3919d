// SPDX-License-Identifier: Apache-2.0
#include "modelled_localiser/pose_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tocsin {
namespace {

constexpr double period_s = 0.2;
const geometry::Pose truth{3, -2, 1};

Time at(double s) { return Time{} + seconds(s); }

TEST(PoseErrorTest, HasTheDeviationAndTheCorrelationThatItIsTold) {
  PoseErrorParams params;
  params.deviation_m = 0.1;
  PoseError sut(params, 1);
  constexpr int count = 100000;
  double square = 0;
  double product = 0;
  double last = 0;
  for (int i = 0; i < count; ++i) {
    const double off = sut.read(truth, at(i * period_s)).value().x_m - truth.x_m;
    square += off * off;
    product += off * last;
    last = off;
  }
  EXPECT_NEAR(std::sqrt(square / count), 0.1, 0.005);
  EXPECT_NEAR(product / square, std::exp(-period_s / params.correlation_s), 0.01);
}

TEST(PoseErrorTest, IsTheSameForTheSameSeed) {
  PoseError one(PoseErrorParams{}, 7);
  PoseError other(PoseErrorParams{}, 7);
  PoseError third(PoseErrorParams{}, 8);
  EXPECT_EQ(one.read(truth, at(0))->x_m, other.read(truth, at(0))->x_m);
  EXPECT_NE(one.read(truth, at(1))->x_m, third.read(truth, at(1))->x_m);
}

TEST(PoseErrorTest, IsLostAsOftenAndAsLongAsItIsTold) {
  PoseErrorParams params;
  params.lost_every_s = 45;
  params.lost_for_s = 5;
  PoseError sut(params, 2);
  int lost = 0;
  constexpr int count = 200000;
  for (int i = 0; i < count; ++i) lost += sut.read(truth, at(i * period_s)) ? 0 : 1;
  EXPECT_NEAR(static_cast<double>(lost) / count, 0.1, 0.01);
}

TEST(PoseErrorTest, DoesNotKnowForAWhileWhenTheVehicleWasCarriedOff) {
  PoseError sut(PoseErrorParams{}, 3);
  EXPECT_TRUE(sut.read(truth, at(0)));
  const geometry::Pose elsewhere{6, 2, 0};
  EXPECT_FALSE(sut.read(elsewhere, at(0.2)));
  EXPECT_FALSE(sut.read(elsewhere, at(5.1)));
  ASSERT_TRUE(sut.read(elsewhere, at(5.3)));
  EXPECT_NEAR(sut.read(elsewhere, at(5.5))->x_m, 6, 0.1);
}

}  // namespace
}  // namespace tocsin
