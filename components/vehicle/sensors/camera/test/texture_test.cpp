// SPDX-License-Identifier: Apache-2.0
#include "camera/texture.hpp"

#include <gtest/gtest.h>

namespace tocsin::camera {
namespace {

/// One metre, white where u is odd.
Texture stripes() {
  return {1.0, [](int u, int) { return u % 2 == 1 ? Color{200, 200, 200} : Color{0, 0, 0}; }};
}

TEST(Texture, ChangesResolutionWhereATexelIsAPixel) {
  const Texture sut = stripes();
  EXPECT_EQ(sut.level(256).per_m(), 256);
  EXPECT_EQ(sut.level(255.9).per_m(), 128);
  EXPECT_EQ(sut.level(128).per_m(), 128);
  EXPECT_EQ(sut.level(0.001).per_m(), 8);
}

TEST(Texture, ShowsTheMeanWhenFar) {
  const Texture sut = stripes();
  EXPECT_EQ(sut.level(1000).at(0, 0)[0], 0) << "near, each texel";
  EXPECT_EQ(sut.level(1000).at(1, 0)[0], 200);
  const auto level = sut.level(128);
  EXPECT_EQ(level.at(0, 0)[0], 100);
  EXPECT_EQ(level.at(1, 5)[2], 100);
}

TEST(Textures, AreWhatTheyShow) {
  const Texture wall = wall_texture(1, 2.8);
  EXPECT_LT(wall.level(1e9).at(0, 2)[0], 100) << "a dark skirting board";
  EXPECT_GT(wall.level(1e9).at(0, 200)[0], 160) << "bright plaster";
  const Texture furniture = furniture_texture(1);
  const auto* brown = furniture.level(1e9).at(3, 10);
  EXPECT_GT(brown[0], brown[1]);
  EXPECT_GT(brown[1], brown[2]);
  EXPECT_GT(ceiling_texture(1).level(0).at(0, 0)[1], floor_texture(1).level(0).at(0, 0)[1]);
}

TEST(Texture, Repeats) {
  const Texture sut = floor_texture(3);
  for (const double pixels_per_m : {1000.0, 50.0}) {
    const auto level = sut.level(pixels_per_m);
    EXPECT_EQ(level.at(5, 7), level.at(5 + Texture::size, 7 - Texture::size));
    EXPECT_EQ(level.at(-1, 0), level.at(Texture::size - 1, 0));
  }
}

TEST(Texture, DependsOnTheSeedOnly) {
  const Texture a = wall_texture(1, 2.8), same = wall_texture(1, 2.8), other = wall_texture(2, 2.8);
  int different = 0;
  for (int v = 0; v < Texture::size; ++v) {
    EXPECT_EQ(a.level(1e9).at(9, v)[0], same.level(1e9).at(9, v)[0]);
    different += a.level(1e9).at(9, v)[0] != other.level(1e9).at(9, v)[0] ? 1 : 0;
  }
  EXPECT_GT(different, Texture::size / 2);
}

}  // namespace
}  // namespace tocsin::camera
