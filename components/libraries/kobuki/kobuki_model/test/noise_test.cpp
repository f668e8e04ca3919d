// SPDX-License-Identifier: Apache-2.0
#include "../src/noise.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tocsin::kobuki {
namespace {

constexpr int draws = 200'000;

TEST(StandardNormal, HasTheSharesOfTheNormalDistribution) {
  std::mt19937_64 random(1);
  std::array<int, 6> below{};
  for (int i = 0; i < draws; ++i) {
    const double draw = standard_normal(random);
    for (std::size_t k = 0; k < below.size(); ++k) {
      if (draw < static_cast<double>(k) - 2) ++below[k];
    }
  }
  for (std::size_t k = 0; k < below.size(); ++k) {
    const double expected = std::erfc(-(static_cast<double>(k) - 2) / std::sqrt(2.0)) / 2;
    const double deviation = std::sqrt(expected * (1 - expected) / draws);
    EXPECT_NEAR(static_cast<double>(below[k]) / draws, expected, 4 * deviation) << k;
  }
}

TEST(StandardNormal, HasTailsBeyondItsLayers) {  // 3.44 is where the ziggurat's layers end
  std::mt19937_64 random(2);
  int far = 0;
  for (int i = 0; i < draws; ++i) far += std::abs(standard_normal(random)) > 3.5 ? 1 : 0;
  EXPECT_NEAR(far, draws * std::erfc(3.5 / std::sqrt(2.0)), 4 * std::sqrt(93));
}

}  // namespace
}  // namespace tocsin::kobuki
