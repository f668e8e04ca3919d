// SPDX-License-Identifier: Apache-2.0
#include "camera/picture_size.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"
#include "geometry/wall.hpp"

namespace tocsin::camera {
namespace {

constexpr double open_bytes = 40712;
constexpr double near_bytes_m = 9600;
constexpr double nearest_wall_m = 0.3;
constexpr double farthest_m = 60;
constexpr double least_bytes = 500;  // tables and headers of a JPEG

/// The middles of as many equal strips of the picture.
Fan fan_of(double field_of_view_deg) {
  const double half_width = std::tan(field_of_view_deg * pi / 360.0);
  Fan sideways{};
  for (std::size_t i = 0; i < sideways.size(); ++i) {
    const double strip = static_cast<double>(i) + 0.5;
    sideways[i] = half_width * (2 * strip / static_cast<double>(sideways.size()) - 1);
  }
  return sideways;
}

}  // namespace

PictureSize::PictureSize(double field_of_view_deg, std::vector<geometry::Wall> walls)
    : sideways_(fan_of(field_of_view_deg)), walls_(std::move(walls)) {}

double PictureSize::law(const geometry::Pose& view) const {
  double sum_per_m = 0;
  for (const double wall_per_m : inverse_depths_per_m(view, sideways_, walls_)) {
    sum_per_m += wall_per_m > 0 ? std::min(wall_per_m, 1 / nearest_wall_m) : 1 / farthest_m;
  }
  return open_bytes - near_bytes_m * sum_per_m / static_cast<double>(sideways_.size());
}

void PictureSize::calibrate(const geometry::Pose& view, std::size_t bytes) {
  factor_ = static_cast<double>(bytes) / law(view);
}

std::size_t PictureSize::bytes(const geometry::Pose& view) const {
  return static_cast<std::size_t>(std::max(least_bytes, factor_ * law(view)));
}

}  // namespace tocsin::camera
