// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tocsin::radio {

/// A Gaussian random field over the plane with correlation exp(-d / dcorr) (Gudmundson 1991), fixed
/// by its seed: every visit to a place meets the same shadow.
///
/// A sum of 160 plane waves whose wave numbers follow the spectrum of that correlation,
/// k (1/dcorr^2 + k^2)^(-3/2). Between the points of a grid of dcorr / 10 it is interpolated, which
/// lowers the variance by about 5 % on average; grid points are computed on the first visit.
class ShadowingField {
 public:
  /// `sigma_db` >= 0; `distance_m` > 0 is where the correlation has fallen to 1/e.
  ShadowingField(double sigma_db, double distance_m, std::uint64_t seed);
  /// Gain at the place, in dB, mean zero over seeds. Remembers what it computed.
  [[nodiscard]] double at(double x_m, double y_m);

 private:
  [[nodiscard]] double at_grid(std::int64_t column, std::int64_t row);
  [[nodiscard]] double sum_of_waves(double x_m, double y_m) const;

  double amplitude_db_;
  double step_m_;
  std::vector<double> kx_;  // turns per metre
  std::vector<double> ky_;
  std::vector<double> phase_;  // turns
  std::unordered_map<std::int64_t, double> grid_;
};

}  // namespace tocsin::radio
