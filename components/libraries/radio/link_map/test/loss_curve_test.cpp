// SPDX-License-Identifier: Apache-2.0
#include "link_map/loss_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::link_map {
namespace {

/// One reading for each dB of the range.
std::vector<Reading> readings_of(const LossCurve& truth, double from_dbm, double to_dbm) {
  std::vector<Reading> readings;
  for (double dbm = from_dbm; dbm <= to_dbm; ++dbm) {
    for (int i = 0; i < 5; ++i) readings.push_back({{0, 0}, dbm, truth.lost_share(dbm)});
  }
  return readings;
}

TEST(LossCurve, IsHalfWhereItSaysAndFallsWithSignal) {
  const LossCurve curve{-70, 2};
  EXPECT_DOUBLE_EQ(curve.lost_share(-70), 0.5);
  EXPECT_GT(curve.lost_share(-80), 0.99);
  EXPECT_LT(curve.lost_share(-60), 0.01);
}

TEST(LossCurve, OfNothingIsTheUsualOne) {
  EXPECT_NEAR(fit_loss_curve({}).half_dbm, -82, 0.01);
  EXPECT_NEAR(fit_loss_curve({{{0, 0}, -60, nan}}).half_dbm, -82, 0.01);
}

TEST(LossCurve, FindsWhereACardLosesHalf) {
  for (const double half_dbm : {-90.0, -74.0, -66.0}) {
    const LossCurve curve = fit_loss_curve(readings_of({half_dbm, 2.5}, -100, -50));
    EXPECT_NEAR(curve.half_dbm, half_dbm, 1.0);
  }
}

TEST(LossCurve, OfGoodLinksOnlyLiesBelowWhatWasSeen) {
  const LossCurve curve = fit_loss_curve(readings_of({-90, 2}, -75, -40));
  EXPECT_LT(curve.half_dbm, -80);
}

TEST(LossCurve, AQueueThatOverflowsNearTheAccessPointDoesNotMoveIt) {
  auto readings = readings_of({-80, 2.5}, -95, -45);
  for (int i = 0; i < 20; ++i) readings.push_back({{0, 0}, -50, 0.6});
  EXPECT_NEAR(fit_loss_curve(readings).half_dbm, -80, 3);
}

TEST(LossCurve, LeavesOutWhatIsNoReading) {
  auto readings = readings_of({-74, 2.5}, -100, -50);
  readings.push_back({{0, 0}, -50, 7});
  readings.push_back({{0, 0}, 30, 1});
  readings.push_back({{0, 0}, nan, 1});
  EXPECT_NEAR(fit_loss_curve(readings).half_dbm, -74, 1);
}

TEST(Risk, IsTheChanceThatTheSignalIsTooLow) {
  const LossCurve curve{-80, 2};
  EXPECT_DOUBLE_EQ(risk(curve, {-80, 5}), 0.5);
  EXPECT_NEAR(risk(curve, {-70, 5}), 0.0228, 1e-4);
  EXPECT_NEAR(risk(curve, {-90, 5}), 0.9772, 1e-4);
  EXPECT_GT(risk(curve, {-70, 10}), 0.15) << "who knows little does not promise";
  EXPECT_NEAR(risk(curve, {-60, 0}), 0, 1e-9);
}

}  // namespace
}  // namespace tocsin::link_map
