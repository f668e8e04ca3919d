// SPDX-License-Identifier: Apache-2.0
#include "camera/ray_caster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/wall.hpp"

namespace tocsin::camera {
namespace {

constexpr double wall_loss_db = 6.9;
constexpr double furniture_loss_db = 0;

constexpr double tiny = 1e-9;

geometry::Wall wall(double x1, double y1, double x2, double y2) {
  return {x1, y1, x2, y2, wall_loss_db};
}
geometry::Wall furniture(double x1, double y1, double x2, double y2) {
  return {x1, y1, x2, y2, furniture_loss_db};
}

std::vector<Hit> hits_of(const geometry::Pose& view, const std::vector<geometry::Wall>& walls,
                         double sideways = 0) {
  std::vector<Hit> hits;
  cast(ray_through(view, sideways), walls, hits);
  return hits;
}

TEST(Ray, GoesAlongTheViewInTheMiddleAndToTheRightForPositiveSideways) {
  const Ray middle = ray_through({1, 2, std::atan2(4, 3)}, 0);
  EXPECT_EQ(middle.x_m, 1);
  EXPECT_EQ(middle.y_m, 2);
  EXPECT_NEAR(middle.dx, 0.6, tiny);
  EXPECT_NEAR(middle.dy, 0.8, tiny);
  const Ray right = ray_through({0, 0, 0}, 0.5);  // looking along x: y is to the left
  EXPECT_NEAR(right.dx, 1, tiny);
  EXPECT_NEAR(right.dy, -0.5, tiny);
}

TEST(Cast, TellsHowFarAWallIs) {
  const auto sut = hits_of({1, 0, 0}, {wall(5, -1, 5, 1)});
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_NEAR(sut[0].depth_m, 4, tiny);
  EXPECT_NEAR(sut[0].along_m, 1, tiny);
  EXPECT_NEAR(sut[0].facing, 1, tiny);
}

TEST(Cast, MeasuresDepthFromThePicturesPlane) {
  // A flat wall must look flat: the same depth in the middle and at the edge.
  const std::vector<geometry::Wall> walls{wall(5, -9, 5, 9)};
  EXPECT_NEAR(hits_of({0, 0, 0}, walls, 0.577).at(0).depth_m, 5, tiny);
  EXPECT_NEAR(hits_of({0, 0, 0}, walls, -0.577).at(0).depth_m, 5, tiny);
}

TEST(Cast, SeesTheWallBehindFurnitureAndDrawsItFirst) {
  const auto sut = hits_of({0, 0, 0}, {furniture(3, -1, 3, 1), wall(5, -1, 5, 1),
                                       furniture(4, -1, 4, 1), furniture(6, -1, 6, 1)});
  ASSERT_EQ(sut.size(), 3U);
  EXPECT_NEAR(sut[0].depth_m, 5, tiny);
  EXPECT_FALSE(sut[0].is_furniture);
  EXPECT_NEAR(sut[1].depth_m, 4, tiny);
  EXPECT_NEAR(sut[2].depth_m, 3, tiny);
  EXPECT_TRUE(sut[2].is_furniture);
}

TEST(Cast, SeesWhatIsAheadWithinItsEndsAndHasASide) {
  struct {
    geometry::Wall wall;
    std::size_t hits;
  } const walls[] = {{wall(-5, -1, -5, 1), 0},        // behind the camera
                     {wall(5, 0.001, 5, 1), 0},       // beside the ray
                     {wall(5, -0.0001, 5, 1), 1},     //
                     {wall(5, 0, 9, 0), 0},           // seen edge-on
                     {wall(5, 0, 5, 0), 0},           // a point
                     {wall(0.049, -1, 0.049, 1), 0},  // touches the lens
                     {wall(0.051, -1, 0.051, 1), 1}};
  for (const auto& [wall, hits] : walls) {
    EXPECT_EQ(hits_of({0, 0, 0}, {wall}).size(), hits) << wall.x1_m << ' ' << wall.y1_m;
  }
}

TEST(Cast, TellsASideLookFromASquareOne) {
  const auto sut = hits_of({0, 0, 0}, {wall(4, -1, 6, 1)});
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_NEAR(sut[0].facing, std::sqrt(0.5), tiny);
}

constexpr Fan fan{-1.2, -0.6, -0.3, -0.1, 0, 0.2, 0.5, 1.5};

/// Along the middle of the view from the origin along x.
double inverse_depth_ahead_per_m(const std::vector<geometry::Wall>& walls) {
  return inverse_depths_per_m({0, 0, 0}, fan, walls)[4];
}

TEST(InverseDepths, DoNotCountAWallSeenFromTheSide) {
  EXPECT_EQ(inverse_depth_ahead_per_m({wall(1, 0, 2, 0)}), 0);
  EXPECT_EQ(inverse_depth_ahead_per_m({wall(-1, 0, 2, 0)}), 0);
  EXPECT_EQ(inverse_depth_ahead_per_m({wall(2, 0, 2, 0)}), 0);
  EXPECT_EQ(inverse_depth_ahead_per_m({wall(1, 0, 2, 0), wall(3, -1, 3, 1)}), 1 / 3.0);
}

/// Of the first that `cast` gives, which is the farthest, if that is a wall.
double cast_per_m(const geometry::Pose& view, const std::vector<geometry::Wall>& walls,
                  double sideways) {
  const auto hits = hits_of(view, walls, sideways);
  return hits.empty() || hits[0].is_furniture ? 0 : 1 / hits[0].depth_m;
}

TEST(InverseDepths, AreThoseThatCastTellsFromEveryPlaceInEveryDirection) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place_m(-4, 4);
  std::vector<geometry::Wall> walls;
  for (int i = 0; i < 30; ++i) {
    walls.push_back({place_m(random), place_m(random), place_m(random), place_m(random),
                     i % 3 == 0 ? furniture_loss_db : wall_loss_db});
  }
  for (int i = 0; i < 300; ++i) {
    const geometry::Pose view{place_m(random), place_m(random), place_m(random)};
    const Fan sut = inverse_depths_per_m(view, fan, i % 2 == 0 ? walls : std::vector(2, walls[1]));
    for (std::size_t ray = 0; ray < fan.size(); ++ray) {
      const double cast = cast_per_m(view, i % 2 == 0 ? walls : std::vector(2, walls[1]), fan[ray]);
      EXPECT_NEAR(sut[ray], cast, 1e-6 * cast) << i << ' ' << ray;
    }
  }
}

}  // namespace
}  // namespace tocsin::camera
