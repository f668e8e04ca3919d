// SPDX-License-Identifier: Apache-2.0
#include "geometry/wall.hpp"

#include <gtest/gtest.h>

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

TEST(Crosses, OnlyWhatGoesThroughTheWall) {
  EXPECT_TRUE(crosses(wall, {0, 0}, {4, 0}));
  EXPECT_TRUE(crosses(wall, {4, 0}, {0, 0}));
  EXPECT_FALSE(crosses(wall, {0, 0}, {1.9, 0}));
  EXPECT_FALSE(crosses(wall, {0, 1.1}, {4, 1.1}));
  EXPECT_TRUE(crosses(wall, {0, 0.99}, {4, 0.99}));
}

TEST(Crosses, NotWhatOnlyTouchesIt) {
  EXPECT_FALSE(crosses(wall, {0, 0}, {2, 0}));
  EXPECT_FALSE(crosses(wall, {0, 1}, {4, 1}));
  EXPECT_FALSE(crosses(wall, {2, -5}, {2, 5}));
}

TEST(NearestPoint, LiesBesideThePointOrAtAnEnd) {
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 0.25}).x_m, 2);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 0.25}).y_m, 0.25);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {5, 9}).y_m, 1);
  EXPECT_DOUBLE_EQ(nearest_point(wall, {-5, -9}).y_m, -1);
}

TEST(NearestPoint, OfAWallWithoutLengthIsItsPlace) {
  const Point nearest = nearest_point({1, 2, 1, 2, 0}, {4, 6});
  EXPECT_EQ(nearest.x_m, 1);
  EXPECT_EQ(nearest.y_m, 2);
}

}  // namespace
}  // namespace tocsin::geometry
