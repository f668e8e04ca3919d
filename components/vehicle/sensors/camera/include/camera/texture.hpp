// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tocsin::camera {

using Color = std::array<std::uint8_t, 3>;

/// A square, repeating pattern of a known size, in several resolutions: a far surface is drawn from
/// a coarse one, so that it does not flicker.
class Texture {
 public:
  static constexpr int size = 256;  ///< texels per side of the finest resolution
  static constexpr int levels = 6;

  /// `paint(u, v)` gives the colour of a texel of the finest resolution.
  Texture(double side_m, const std::function<Color(int u, int v)>& paint);

  /// One resolution, to be read many times.
  class Level {
   public:
    Level(const std::uint8_t* texels, int shift, double per_m)
        : texels_(texels), mask_((size >> shift) - 1), bits_(8 - shift), per_m_(per_m) {}
    /// Texels per metre, to turn lengths into texel coordinates.
    [[nodiscard]] double per_m() const { return per_m_; }
    /// The three bytes of a texel; coordinates of any value, they repeat.
    [[nodiscard]] const std::uint8_t* at(int u, int v) const {
      return texels_ + 3 * (static_cast<std::size_t>(u & mask_) << bits_ |
                            static_cast<std::size_t>(v & mask_));
    }

   private:
    const std::uint8_t* texels_;
    int mask_;
    int bits_;
    double per_m_;
  };

  /// The resolution whose texels are not smaller than a pixel, when `pixels_per_m` pixels of the
  /// picture show one metre of the surface. The coarsest at most.
  [[nodiscard]] Level level(double pixels_per_m) const;

 private:
  double per_m_;
  std::array<std::vector<std::uint8_t>, levels> texels_;
};

/// The surfaces of the building, each with fine detail that depends on `seed` only.
[[nodiscard]] Texture wall_texture(std::uint32_t seed, double height_m);
[[nodiscard]] Texture furniture_texture(std::uint32_t seed);
[[nodiscard]] Texture floor_texture(std::uint32_t seed);
[[nodiscard]] Texture ceiling_texture(std::uint32_t seed);

}  // namespace tocsin::camera
