// SPDX-License-Identifier: Apache-2.0
#include "camera/picture_size.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tocsin::camera {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double open_bytes = 40712;
constexpr double near_bytes_m = 9600;
constexpr double nearest_m = 0.3;
constexpr double farthest_m = 60;
constexpr double least_bytes = 500;  // tables and headers of a JPEG
constexpr int rays = 8;

}  // namespace

PictureSize::PictureSize(double field_of_view_deg, std::vector<Wall> walls)
    : half_width_(std::tan(field_of_view_deg * pi / 360.0)), walls_(std::move(walls)) {}

double PictureSize::law(const View& view) {
  double inverse_per_m = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray ray = ray_through(view, half_width_ * ((2 * i + 1.0) / rays - 1));
    const double depth_m = depth_to_wall_m(ray, walls_).value_or(farthest_m);
    inverse_per_m += 1 / std::max(depth_m, nearest_m) / rays;
  }
  return open_bytes - near_bytes_m * inverse_per_m;
}

void PictureSize::calibrate(const View& view, std::size_t bytes) {
  factor_ = static_cast<double>(bytes) / law(view);
}

std::size_t PictureSize::bytes(const View& view) {
  return static_cast<std::size_t>(std::max(least_bytes, factor_ * law(view)));
}

}  // namespace tocsin::camera
