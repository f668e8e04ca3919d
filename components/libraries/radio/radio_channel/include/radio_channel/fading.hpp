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
  /// Moves to a place where the direct wave has the power `k_db` over the scattered ones.
  void move_to(double x_m, double y_m, double k_db);
  /// Gain at the place in dB, mean power 0 dB, never below -60 dB.
  [[nodiscard]] double gain_db(double t_s) const;

 private:
  static constexpr std::size_t wave_count = 16;
  using Waves = std::array<double, wave_count>;
  Waves kx_;       // turns per metre
  Waves ky_;       // turns per metre
  Waves doppler_;  // turns per second
  Waves phase_;    // turns
  Waves turns_;    // at the place, time zero
  double direct_kx_;
  double direct_ky_;
  double scattered_ = 0;  // amplitude of one wave
  double direct_re_ = 1;
  double direct_im_ = 0;
};

}  // namespace tocsin::radio
