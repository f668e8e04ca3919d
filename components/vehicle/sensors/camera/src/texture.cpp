// SPDX-License-Identifier: Apache-2.0
#include "camera/texture.hpp"

#include <algorithm>

namespace tocsin::camera {
namespace {

/// A number that looks random, the same for the same arguments (Wang's integer hash).
std::uint32_t scatter(std::uint32_t seed, int u, int v) {
  std::uint32_t x = seed * 0x9e3779b9U + static_cast<std::uint32_t>(u) * 0x85ebca6bU +
                    static_cast<std::uint32_t>(v) * 0xc2b2ae35U;
  x = (x ^ 61U) ^ (x >> 16);
  x *= 9U;
  x ^= x >> 4;
  x *= 0x27d4eb2dU;
  return x ^ (x >> 15);
}

/// Uneven brightness: coarse patches and fine grain, within +-`strength` / 2 each.
int grain(std::uint32_t seed, int u, int v, int strength) {
  const auto part = [strength](std::uint32_t x) {
    return static_cast<int>(x % static_cast<std::uint32_t>(strength + 1)) - strength / 2;
  };
  return part(scatter(seed, u, v)) + part(scatter(seed + 1, u / 8, v / 8));
}

Color brighter(const Color& color, int by) {
  Color result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = static_cast<std::uint8_t>(std::clamp(color[i] + by, 0, 255));
  }
  return result;
}

/// Half the resolution: each texel the mean of four.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& fine, int side) {
  const auto n = static_cast<std::size_t>(side);
  std::vector<std::uint8_t> coarse(3 * (n / 2) * (n / 2));
  const auto at = [&fine, n](std::size_t u, std::size_t v, std::size_t i) {
    return static_cast<int>(fine[3 * (u * n + v) + i]);
  };
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    const std::size_t u = k / 3 / (n / 2) * 2, v = k / 3 % (n / 2) * 2, i = k % 3;
    const int sum = at(u, v, i) + at(u + 1, v, i) + at(u, v + 1, i) + at(u + 1, v + 1, i);
    coarse[k] = static_cast<std::uint8_t>(sum / 4);
  }
  return coarse;
}

}  // namespace

Texture::Texture(double side_m, const std::function<Color(int, int)>& paint)
    : per_m_(size / side_m) {
  texels_[0].reserve(std::size_t{3} * size * size);
  for (int u = 0; u < size; ++u) {
    for (int v = 0; v < size; ++v) {
      const Color color = paint(u, v);
      texels_[0].insert(texels_[0].end(), color.begin(), color.end());
    }
  }
  for (std::size_t i = 1; i < levels; ++i) texels_[i] = halved(texels_[i - 1], size >> (i - 1));
}

Texture::Level Texture::level(double pixels_per_m) const {
  int shift = 0;
  double per_m = per_m_;
  while (shift + 1 < levels && per_m > pixels_per_m) {
    ++shift;
    per_m /= 2;
  }
  return {texels_[static_cast<std::size_t>(shift)].data(), shift, per_m};
}

Texture wall_texture(std::uint32_t seed, double height_m) {
  // v is the height above the floor: skirting board, painted dado, rail, plaster.
  const auto row = [height_m](double m) { return static_cast<int>(m / height_m * Texture::size); };
  const int skirting = row(0.1), dado = row(1.1), rail = row(1.16);
  return {height_m, [=](int u, int v) {
            const int uneven = grain(seed, u, v, 22);
            if (v < skirting) return brighter({70, 60, 52}, uneven / 2);
            if (v < dado) return brighter({126, 148, 138}, uneven);
            if (v < rail) return brighter({96, 78, 60}, uneven / 2);
            return brighter({206, 200, 184}, uneven);
          }};
}

Texture furniture_texture(std::uint32_t seed) {
  // Boards of wood: grain along u, a dark joint every 32 texels.
  return {1.0, [seed](int u, int v) {
            const int lines = static_cast<int>(scatter(seed, u / 24, v) % 36U) - 18;
            const int joint = v % 32 == 0 ? -50 : 0;
            return brighter({150, 108, 66}, lines + joint + grain(seed, u, v, 10));
          }};
}

Texture floor_texture(std::uint32_t seed) {
  // Four by four tiles of 0.3 m with joints.
  return {1.2, [seed](int u, int v) {
            const bool joint = u % 64 < 2 || v % 64 < 2;
            const int tile = static_cast<int>(scatter(seed, u / 64, v / 64) % 24U) - 12;
            return brighter({128, 122, 114}, joint ? -60 : tile + grain(seed, u, v, 20));
          }};
}

Texture ceiling_texture(std::uint32_t seed) {
  // Panels of 0.6 m with holes.
  return {1.2, [seed](int u, int v) {
            const bool joint = u % 128 < 2 || v % 128 < 2;
            const bool hole = u % 8 < 2 && v % 8 < 2;
            return brighter({214, 214, 210}, (joint ? -70 : hole ? -45 : 0) + grain(seed, u, v, 8));
          }};
}

}  // namespace tocsin::camera
