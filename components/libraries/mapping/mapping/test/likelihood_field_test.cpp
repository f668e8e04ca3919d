// SPDX-License-Identifier: Apache-2.0
#include "mapping/likelihood_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tocsin::mapping {
namespace {

LikelihoodField field_of(const Points& points) {
  LikelihoodField field(0.05, 0.1);
  field.stamp(points);
  return field;
}

TEST(LikelihoodField, IsOneAtAPointAndFallsAsABell) {
  const auto sut = field_of({{1, 1}});
  EXPECT_NEAR(sut.at(1, 1).value, 1, 0.1);
  EXPECT_NEAR(sut.at(1.1, 1).value, std::exp(-0.5), 0.05);
  EXPECT_NEAR(sut.at(1, 0.8).value, std::exp(-2.0), 0.05);
}

TEST(LikelihoodField, HasTheNearestPointOfTwo) {
  const auto sut = field_of({{1, 1}, {1.1, 1}});
  EXPECT_NEAR(sut.at(1.2, 1).value, std::exp(-0.5), 0.05);
}

TEST(LikelihoodField, IsZeroFarAwayOutsideAndForNan) {
  const auto sut = field_of({{1, 1}});
  EXPECT_EQ(sut.at(2, 1).value, 0);
  EXPECT_EQ(sut.at(1e9, -1e9).value, 0);
  EXPECT_EQ(sut.at(nan, 1).value, 0);
  EXPECT_EQ(LikelihoodField(0.05, 0.1).at(0, 0).value, 0);
}

TEST(LikelihoodField, ItsSlopesAreThoseOfItsValues) {
  const auto sut = field_of({{1, 1}, {1.2, 1.1}});
  constexpr double h = 1e-6;
  for (const auto& [x, y] : {std::pair{1.051, 1.032}, {0.93, 1.11}, {1.26, 0.97}}) {
    const auto sample = sut.at(x, y);
    EXPECT_NEAR(sample.slope_x_per_m, (sut.at(x + h, y).value - sample.value) / h, 1e-3);
    EXPECT_NEAR(sample.slope_y_per_m, (sut.at(x, y + h).value - sample.value) / h, 1e-3);
  }
}

TEST(LikelihoodField, ItsCurvatureIsThatOfItsValuesOverSigma) {
  const auto sut = field_of({{1, 1}, {1.2, 1.1}});
  constexpr double h = 0.1;
  for (const auto& [x, y] : {std::pair{1.051, 1.032}, {0.93, 1.11}, {1.26, 0.97}}) {
    const auto value = [&, x = x, y = y](double dx, double dy) {
      return sut.at(x + dx * h, y + dy * h).value;
    };
    const auto curvature = sut.curvature_at(x, y);
    const double here = value(0, 0);
    EXPECT_NEAR(curvature.xx, (value(1, 0) - 2 * here + value(-1, 0)) / (h * h), 1e-9);
    EXPECT_NEAR(curvature.yy, (value(0, 1) - 2 * here + value(0, -1)) / (h * h), 1e-9);
    EXPECT_NEAR(curvature.xy,
                (value(1, 1) - value(1, -1) - value(-1, 1) + value(-1, -1)) / (4 * h * h), 1e-9);
  }
}

TEST(LikelihoodField, HasNoCurvatureFarAwayOutsideAndForNan) {
  const auto sut = field_of({{1, 1}});
  for (const double x : {2.0, 1e9, -1e9, nan}) {
    const auto curvature = sut.curvature_at(x, 1);
    EXPECT_EQ(curvature.xx, 0) << x;
    EXPECT_EQ(curvature.xy, 0) << x;
    EXPECT_EQ(curvature.yy, 0) << x;
  }
}

TEST(FieldBounds, NoCellReachesMoreThanItsBound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 3);
  Points points;
  for (int i = 0; i < 20; ++i) points.push_back({place(random), place(random)});
  const auto field = field_of(points);
  const FieldBounds sut(field);
  const auto value = [&](int level, int column, int row) {
    const navigation::CellIndex cell{column, row};
    return sut.sum(level, &cell, 1, {0, 0}, -1);
  };
  std::uniform_int_distribution<int> cell(-40, field.grid().width + 40);
  std::uniform_int_distribution<int> part(0, 1 << 20);
  for (int i = 0; i < 20'000; ++i) {
    const int level = i % FieldBounds::levels;
    const int column = cell(random);
    const int row = cell(random);
    const int moved =
        value(0, column + part(random) % (1 << level), row + part(random) % (1 << level));
    EXPECT_LE(moved, value(level, column, row)) << level;
  }
}

TEST(FieldBounds, StopsOnlyWhenMoreThanNeededIsOutOfReach) {
  const auto field = field_of({{1, 1}});
  const FieldBounds sut(field);
  const auto centre = field.grid().cell_of({1.01, 1.01}).value();
  const std::vector<navigation::CellIndex> cells(100, centre);
  const int all = sut.sum(0, cells.data(), cells.size(), {0, 0}, -1);
  EXPECT_GT(all, 100 * 200);
  EXPECT_EQ(sut.sum(0, cells.data(), cells.size(), {0, 0}, all - 1), all);
  EXPECT_LE(sut.sum(0, cells.data(), cells.size(), {0, 0}, 100 * 255), 100 * 255);
}

}  // namespace
}  // namespace tocsin::mapping
