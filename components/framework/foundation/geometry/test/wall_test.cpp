// SPDX-License-Identifier: Apache-2.0
#include "geometry/wall.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace tocsin::geometry {
namespace {

const Wall wall{2, -1, 2, 1, 6.9};  // between x < 2 and x > 2, for |y| < 1

TEST(Wall, IsFurnitureWithoutLoss) {
  EXPECT_FALSE(wall.is_furniture());
  EXPECT_FALSE((Wall{0, 0, 1, 0, 0.1}.is_furniture()));
  EXPECT_TRUE((Wall{0, 0, 1, 0, 0}.is_furniture()));
}

TEST(Side, IsPositiveToTheLeft) {
  EXPECT_GT(side({0, 0}, {1, 0}, {0.5, 0.1}), 0);
  EXPECT_LT(side({0, 0}, {1, 0}, {0.5, -0.1}), 0);
  EXPECT_EQ(side({0, 0}, {1, 0}, {7, 0}), 0);
}

TEST(Crosses, WhatGoesThroughTheWallAndNotWhatOnlyTouchesIt) {
  for (const auto& [from, to, through] : {std::tuple(Point{0, 0}, Point{4, 0}, true),
                                          {{4, 0}, {0, 0}, true},
                                          {{0, 0}, {1.9, 0}, false},
                                          {{0, 1.1}, {4, 1.1}, false},
                                          {{0, 0.99}, {4, 0.99}, true},
                                          {{0, 0}, {2, 0}, false},
                                          {{0, 1}, {4, 1}, false},
                                          {{2, -5}, {2, 5}, false}}) {
    EXPECT_EQ(crosses(wall, from, to), through) << from.x_m << ' ' << from.y_m;
  }
}

TEST(NearestPoint, LiesBesideThePointOrAtAnEnd) {
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 0.25}).x_m, 2);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 0.25}).y_m, 0.25);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 9}).y_m, 1);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {-5, -9}).y_m, -1);
  EXPECT_EQ(nearest_point({1, 2, 1, 2, 0}, {4, 6}).y_m, 2) << "a wall without length";
}

}  // namespace
}  // namespace tocsin::geometry
