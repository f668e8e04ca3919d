// SPDX-License-Identifier: Apache-2.0
#include "camera/renderer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include "foundation/numbers.hpp"
#include "geometry/wall.hpp"

namespace tocsin::camera {
namespace {

constexpr std::size_t noise_size = 65536;

/// Gaussian noise, more of it than one row needs.
std::vector<std::int8_t> make_noise(const CameraParams& params) {
  std::mt19937 random(static_cast<std::uint32_t>(params.seed));
  std::normal_distribution<double> normal(0, 1);
  std::vector<std::int8_t> noise(noise_size + 3 * static_cast<std::size_t>(params.width));
  for (auto& value : noise) {
    value = static_cast<std::int8_t>(
        std::clamp(std::lround(params.sensor_noise * normal(random)), -127L, 127L));
  }
  return noise;
}

/// Brightness in 1/256: lamps near the camera, and a rest of light everywhere.
int shade(double depth_m, double facing) {
  const double fall_off = depth_m / 9.0;
  const double light = 0.2 + 0.8 / (1.0 + fall_off * fall_off);
  return static_cast<int>(256.0 * light * (0.7 + 0.3 * facing));
}

/// A coordinate that runs over a texture, 16 bits after the point.
struct Runner {
  std::int64_t at;
  std::int64_t step;
  Runner(double start, double each)
      : at(std::llround(start * 65536)), step(std::llround(each * 65536)) {}
  int next() {
    const auto texel = static_cast<int>(at >> 16);
    at += step;
    return texel;
  }
};

void put(std::uint8_t* pixel, const std::uint8_t* texel, int shaded) {
  for (int i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(texel[i] * shaded >> 8);
}

}  // namespace

Renderer::Renderer(const CameraParams& params, std::vector<geometry::Wall> walls)
    : params_(params),
      walls_(std::move(walls)),
      focal_px_(params.width / 2.0 / std::tan(params.field_of_view_deg * pi / 360.0)),
      wall_texture_(wall_texture(static_cast<std::uint32_t>(params.seed), wall_height_m)),
      furniture_texture_(furniture_texture(static_cast<std::uint32_t>(params.seed))),
      floor_texture_(floor_texture(static_cast<std::uint32_t>(params.seed))),
      ceiling_texture_(ceiling_texture(static_cast<std::uint32_t>(params.seed))),
      noise_(make_noise(params)),
      picture_(params.width, params.height) {}

const Picture& Renderer::render(const geometry::Pose& view, std::uint32_t frame,
                                const std::vector<geometry::Wall>& people) {
  assert(std::isfinite(view.x_m) && std::isfinite(view.y_m) && std::isfinite(view.heading_rad));
  for (int row = 0; row < params_.height; ++row) draw_row(view, row);
  for (int column = 0; column < params_.width; ++column) {
    draw_column(column, ray_through(view, sideways(column)), people);
  }
  add_noise(frame);
  return picture_;
}

/// What is nearer is drawn over what is farther.
void Renderer::draw_column(int column, const Ray& ray, const std::vector<geometry::Wall>& people) {
  cast(ray, walls_, hits_);
  cast(ray, people, people_hits_);
  auto person = people_hits_.cbegin();
  const auto draw_people = [&](double beyond_m) {
    for (; person != people_hits_.cend() && person->depth_m > beyond_m; ++person) {
      draw_strip(column, *person, person_height_m);
    }
  };
  for (const Hit& hit : hits_) {
    draw_people(hit.depth_m);
    draw_strip(column, hit, hit.is_furniture ? furniture_height_m : wall_height_m);
  }
  draw_people(0);
}

double Renderer::sideways(int column) const {
  return (column + 0.5 - params_.width / 2.0) / focal_px_;
}

double Renderer::below_horizon(int row) const { return row + 0.5 - params_.height / 2.0; }

void Renderer::draw_row(const geometry::Pose& view, int row) {
  constexpr double farthest_m = 60;
  const double below_px = below_horizon(row);
  const double off_axis_m =
      below_px > 0 ? params_.camera_height_m : wall_height_m - params_.camera_height_m;
  const double depth_m =
      std::min(farthest_m, focal_px_ * off_axis_m / std::max(std::abs(below_px), 0.5));
  // Squeezed in depth by off_axis / depth: a resolution between that of the two directions.
  const double pixels_per_m = focal_px_ / depth_m * std::sqrt(std::min(1.0, off_axis_m / depth_m));
  const auto texture = (below_px > 0 ? floor_texture_ : ceiling_texture_).level(pixels_per_m);
  const double side = Texture::size;
  const Ray left = ray_through(view, sideways(0)), next = ray_through(view, sideways(1));
  const auto along = [&](double start_m, double d, double d_next) {
    return Runner(std::fmod(start_m * texture.per_m(), side) + depth_m * d * texture.per_m(),
                  depth_m * (d_next - d) * texture.per_m());
  };
  Runner u = along(left.x_m, left.dx, next.dx), v = along(left.y_m, left.dy, next.dy);
  const int shaded = shade(depth_m, 1.0);
  std::uint8_t* pixel = picture_.at(0, row);
  for (int column = 0; column < params_.width; ++column, pixel += 3) {
    const int texel_u = u.next();
    put(pixel, texture.at(texel_u, v.next()), shaded);
  }
}

void Renderer::draw_strip(int column, const Hit& hit, double height_m) {
  const double pixels_per_m = focal_px_ / hit.depth_m;
  const double middle = params_.height / 2.0;
  const double bottom = middle + params_.camera_height_m * pixels_per_m;
  const double top = bottom - height_m * pixels_per_m;
  const auto row_at = [this](double y) {
    return static_cast<int>(
        std::ceil(std::clamp(y, 0.0, static_cast<double>(params_.height)) - 0.5));
  };
  const int first = row_at(top), last = row_at(bottom);
  const auto texture = (hit.is_furniture ? furniture_texture_ : wall_texture_).level(pixels_per_m);
  const int u = static_cast<int>(std::fmod(hit.along_m * texture.per_m(), Texture::size));
  const double texels_per_row = texture.per_m() / pixels_per_m;
  Runner v((bottom - first - 0.5) * texels_per_row, -texels_per_row);
  const int shaded = shade(hit.depth_m, hit.facing);
  for (int row = first; row < last; ++row)
    put(picture_.at(column, row), texture.at(u, v.next()), shaded);
}

void Renderer::add_noise(std::uint32_t frame) {
  if (params_.sensor_noise == 0) return;
  std::minstd_rand random(frame * 2654435761U + 1U);
  const int width = 3 * params_.width;
  for (int row = 0; row < params_.height; ++row) {
    const std::int8_t* noise = &noise_[random() % noise_size];
    std::uint8_t* pixel = picture_.at(0, row);
    for (int i = 0; i < width; ++i) {
      pixel[i] = static_cast<std::uint8_t>(std::clamp(pixel[i] + noise[i], 0, 255));
    }
  }
}

}  // namespace tocsin::camera
