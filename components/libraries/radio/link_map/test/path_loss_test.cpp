// SPDX-License-Identifier: Apache-2.0
#include "link_map/path_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tocsin::link_map {
namespace {

using geometry::Point;

std::vector<Point> ring() {
  std::vector<Point> places;
  for (int i = 0; i < 40; ++i)
    places.push_back({10 * std::cos(i * 0.157), 6 * std::sin(i * 0.157)});
  return places;
}

Eigen::VectorXd signals_of(const PathLoss& truth, const std::vector<Point>& places) {
  Eigen::VectorXd signals(static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    signals(static_cast<Eigen::Index>(i)) = truth.signal_dbm(places[i]);
  }
  return signals;
}

TEST(PathLoss, FallsByTenTimesTheExponentADecade) {
  const PathLoss sut{{1, 2}, -40, 3};
  EXPECT_DOUBLE_EQ(sut.signal_dbm({1, 3}), -40);
  EXPECT_DOUBLE_EQ(sut.signal_dbm({11, 2}), -70);
  EXPECT_DOUBLE_EQ(sut.signal_dbm({1, 2}), -40) << "nearer than 1 m it is as strong as there";
}

TEST(PathLoss, FindsAnAccessPointThatItIsNotToldOf) {
  const PathLoss truth{{6, -3}, -38, 2.6};
  const PathLoss sut = fit_path_loss(ring(), signals_of(truth, ring()));
  EXPECT_LT(geometry::distance(sut.access_point, truth.access_point), 4);
  EXPECT_NEAR(sut.exponent, truth.exponent, 0.5);
  for (const Point& place : ring()) {
    EXPECT_NEAR(sut.signal_dbm(place), truth.signal_dbm(place), 3);
  }
}

TEST(PathLoss, AWayAroundItTeachesNoNonsense) {
  std::vector<Point> circle;
  for (int i = 0; i < 40; ++i) circle.push_back({5 * std::cos(i * 0.157), 5 * std::sin(i * 0.157)});
  const PathLoss sut = fit_path_loss(circle, signals_of({{0, 0}, -40, 3}, circle));
  EXPECT_GE(sut.exponent, 1);
  EXPECT_LE(sut.exponent, 6);
}

TEST(PathLoss, LooksAroundALargeSiteInAsManySteps) {
  EXPECT_LT(access_points_around({{0, 0}, {3000, 2000}}).size(), 400U);
  EXPECT_GT(access_points_around({{0, 0}}).size(), 100U);
}

}  // namespace
}  // namespace tocsin::link_map
