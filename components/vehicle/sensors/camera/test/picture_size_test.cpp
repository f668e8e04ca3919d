// SPDX-License-Identifier: Apache-2.0
#include "camera/picture_size.hpp"

#include <gtest/gtest.h>

#include "camera/jpeg.hpp"
#include "camera/renderer.hpp"
#include "geometry/wall_file.hpp"

namespace tocsin::camera {
namespace {

constexpr double wall_loss_db = 6.9;

const std::vector<geometry::Wall>& classroom() {
  static const auto walls =
      geometry::load_walls(TOCSIN_REPOSITORY "/config/maps/classroom.walls.yaml");
  return walls;
}

/// Places of Mission A.
const std::vector<geometry::Pose> places{{-0.49, 0.47, 1.14}, {3.33, -1.91, -0.06},
                                         {6.14, -1.54, 0.64}, {7.54, 2.21, 1.24},
                                         {7.4, 3.11, -2.9},   {2.83, 4.15, 2.91}};

TEST(PictureSize, IsThatOfTheDrawnPictureWithinATenthInTheMean) {
  Renderer renderer(CameraParams{}, classroom());
  PictureSize sut(CameraParams{}.field_of_view_deg, classroom());
  double drawn = 0;
  double told = 0;
  for (const geometry::Pose& view : places) {
    drawn += static_cast<double>(encode_jpeg(renderer.render(view, 1), 65).size());
    told += static_cast<double>(sut.bytes(view));
  }
  EXPECT_NEAR(told / drawn, 1, 0.1);
}

TEST(PictureSize, IsThatOfOneDrawnPictureAfterCalibrationWithinAFifthEverywhere) {
  CameraParams small;
  small.width = 320;
  small.height = 240;
  Renderer renderer(small, classroom());
  PictureSize sut(small.field_of_view_deg, classroom());
  sut.calibrate(places[0], encode_jpeg(renderer.render(places[0], 1), 30).size());
  for (const geometry::Pose& view : places) {
    const auto drawn = static_cast<double>(encode_jpeg(renderer.render(view, 1), 30).size());
    EXPECT_NEAR(static_cast<double>(sut.bytes(view)) / drawn, 1, 0.2);
  }
}

TEST(PictureSize, IsAtLeastThatOfHeaders) {
  PictureSize sut(60, {{2, -9, 2, 9, wall_loss_db}});
  EXPECT_LT(sut.bytes({1.5, 0, 0}), sut.bytes({-5, 0, 0}));
  sut.calibrate({0, 0, 0}, 1);
  EXPECT_EQ(sut.bytes({0, 0, 0}), 500U);
}

}  // namespace
}  // namespace tocsin::camera
