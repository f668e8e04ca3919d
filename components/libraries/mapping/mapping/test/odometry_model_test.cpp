// SPDX-License-Identifier: Apache-2.0
#include "mapping/odometry_model.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin::mapping {
namespace {

TEST(OdometryModel, BelievesTheWheelsAtFirst) {
  const auto step = OdometryModel().corrected({0.5, 0.1, 0.2});
  EXPECT_DOUBLE_EQ(step.x_m, 0.5);
  EXPECT_DOUBLE_EQ(step.heading_rad, 0.2);
}

TEST(OdometryModel, LearnsHowMuchTheWheelsTurnTooLittle) {
  OdometryModel sut;
  std::mt19937 random(1);
  std::normal_distribution<double> turn(0, 0.3);
  for (int i = 0; i < 300; ++i) {
    const double turn_rad = turn(random);
    sut.learn({0.5, 0, turn_rad}, {0.5, 0, 0.95 * turn_rad + 0.5 * 0.05});
  }
  EXPECT_NEAR(sut.corrected({1, 0, 0}).heading_rad, 0.05, 0.025);
  EXPECT_NEAR(sut.corrected({0, 0, 1}).heading_rad, 0.95, 0.025);
  EXPECT_GT(sut.corrected({1, 0, 0}).y_m, 0.01);  // the way bends to the side it turns to
}

TEST(OdometryModel, AWheelThatSlipsForLongTeachesItOnlySoMuch) {
  OdometryModel sut;
  for (int i = 0; i < 50; ++i) sut.learn({0.5, 0, 0}, {0.5, 0, 2.5});
  EXPECT_LE(sut.corrected({1, 0, 0}).heading_rad, 0.1);
}

TEST(OdometryModel, SearchesFartherAfterALongerStepUpToALimit) {
  EXPECT_LT(OdometryModel::window({0.1, 0, 0}).distance_m,
            OdometryModel::window({0.5, 0, 0}).distance_m);
  EXPECT_LT(OdometryModel::window({0.1, 0, 0}).turn_rad,
            OdometryModel::window({0.1, 0, 0.5}).turn_rad);
  EXPECT_LE(OdometryModel::window({100, 0, 3}).distance_m, 0.8);
  EXPECT_LE(OdometryModel::window({100, 0, 3}).turn_rad, 0.9);
}

}  // namespace
}  // namespace tocsin::mapping
