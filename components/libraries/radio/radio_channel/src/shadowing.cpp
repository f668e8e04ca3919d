// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/shadowing.hpp"

#include <cmath>

#include "foundation/numbers.hpp"
#include "radio_channel/random.hpp"
#include "waves.hpp"

namespace tocsin::radio {
namespace {

constexpr int wave_count = 160;

}  // namespace

ShadowingField::ShadowingField(double sigma_db, double distance_m, std::uint64_t seed)
    : amplitude_db_(sigma_db * std::sqrt(2.0 / wave_count)), step_m_(distance_m / 10) {
  RandomStream random(seed, 1);
  for (int i = 0; i < wave_count; ++i) {
    // Inverse of the radial distribution 1 - 1/sqrt(1 + (k dcorr)^2), one wave per equal share.
    const double u = 1 - (i + random.uniform()) / wave_count;
    const double turns_per_m = std::sqrt(1 / (u * u) - 1) / distance_m / (2 * pi);
    const double direction = random.uniform();
    kx_.push_back(turns_per_m * cos_turns(direction));
    ky_.push_back(turns_per_m * cos_turns(direction - 0.25));
    phase_.push_back(random.uniform());
  }
}

double ShadowingField::sum_of_waves(double x_m, double y_m) const {
  double values[wave_count];
  for (std::size_t i = 0; i < wave_count; ++i) {
    values[i] = cos_turns(kx_[i] * x_m + ky_[i] * y_m + phase_[i]);
  }
  double sum = 0;
  for (const double value : values) sum += value;
  return amplitude_db_ * sum;
}

double ShadowingField::at_grid(std::int64_t column, std::int64_t row) {
  const auto [place, is_new] = grid_.try_emplace(column * (std::int64_t{1} << 32) + row, 0.0);
  if (is_new) {
    place->second =
        sum_of_waves(static_cast<double>(column) * step_m_, static_cast<double>(row) * step_m_);
  }
  return place->second;
}

double ShadowingField::at(double x_m, double y_m) {
  if (amplitude_db_ == 0) return 0;
  const double column = std::floor(x_m / step_m_);
  const double row = std::floor(y_m / step_m_);
  const auto i = static_cast<std::int64_t>(column);
  const auto j = static_cast<std::int64_t>(row);
  const double u = x_m / step_m_ - column;
  const double v = y_m / step_m_ - row;
  return (1 - v) * ((1 - u) * at_grid(i, j) + u * at_grid(i + 1, j)) +
         v * ((1 - u) * at_grid(i, j + 1) + u * at_grid(i + 1, j + 1));
}

}  // namespace tocsin::radio
