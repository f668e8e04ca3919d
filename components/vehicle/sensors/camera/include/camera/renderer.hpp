// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/picture.hpp"
#include "camera/ray_caster.hpp"
#include "camera/texture.hpp"
#include "geometry/wall.hpp"

namespace tocsin::camera {

/// The lens, the sensor, and where the camera sits.
struct CameraParams {
  int width = 640;
  int height = 480;
  double field_of_view_deg = 60;
  double camera_height_m = 0.3;
  double sensor_noise = 4;
  int seed = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v("width", width, {64, 1920}, "[px] of the picture");
    v("height", height, {48, 1080}, "[px] of the picture");
    v("field_of_view_deg", field_of_view_deg, {20, 120}, "[deg] from the left to the right edge");
    v("camera_height_m", camera_height_m, {0.05, 0.7}, "[m] lens above the floor; below tables");
    v("sensor_noise", sensor_noise, {0, 40}, "[1] standard deviation, of 255 grey levels");
    v("seed", seed, {0, 1e9}, "[1] of surfaces and noise");
  }
};

/// Draws what a camera on the vehicle sees of the building.
///
/// Pure: the same walls, parameters, view and frame number give the same picture. One ray per
/// column; walls reach to the ceiling, furniture is lower; surfaces get darker with distance.
class Renderer {
 public:
  static constexpr double wall_height_m = 2.8;
  static constexpr double furniture_height_m = 0.75;
  static constexpr double person_height_m = 1.7;

  Renderer(const CameraParams& params, std::vector<geometry::Wall> walls);

  /// The picture from `view`, which must be finite. Valid until the next call. `frame` selects the
  /// sensor noise. `people`: what else stands there now, as high as a person.
  [[nodiscard]] const Picture& render(const geometry::Pose& view, std::uint32_t frame,
                                      const std::vector<geometry::Wall>& people = {});

 private:
  void draw_row(const geometry::Pose& view, int row);
  void draw_column(int column, const Ray& ray, const std::vector<geometry::Wall>& people);
  void draw_strip(int column, const Hit& hit, double height_m);
  void add_noise(std::uint32_t frame);
  /// Of the middle of a column, in focal lengths to the right of the picture's middle.
  [[nodiscard]] double sideways(int column) const;
  /// Of the middle of a row, in pixels below the horizon.
  [[nodiscard]] double below_horizon(int row) const;

  CameraParams params_;
  std::vector<geometry::Wall> walls_;
  double focal_px_;
  Texture wall_texture_;
  Texture furniture_texture_;
  Texture floor_texture_;
  Texture ceiling_texture_;
  std::vector<std::int8_t> noise_;
  std::vector<Hit> hits_;
  std::vector<Hit> people_hits_;
  Picture picture_;
};

}  // namespace tocsin::camera
