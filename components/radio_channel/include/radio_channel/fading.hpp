// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace tocsin::radio {

/// Small-scale Rician fading over position and time, fixed by its seed: one direct wave and 16
/// scattered ones from evenly spread directions, each with a Doppler shift of its own from people
/// who move around.
class RicianFading {
 public:
  /// `wavelength_m` > 0; `doppler_hz` >= 0 is the largest shift by the environment.
  RicianFading(double wavelength_m, double doppler_hz, std::uint64_t seed);
  /// Gain in dB, mean power 0 dB. `k_db` is the power of the direct wave over the scattered ones.
  [[nodiscard]] double gain_db(double k_db, double x_m, double y_m, double t_s) const;

 private:
  static constexpr std::size_t wave_count = 16;
  using Waves = std::array<double, wave_count>;
  Waves kx_;       // turns per metre
  Waves ky_;       // turns per metre
  Waves doppler_;  // turns per second
  Waves phase_;    // turns
  double direct_kx_;
  double direct_ky_;
};

}  // namespace tocsin::radio
