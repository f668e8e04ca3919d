// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/fading.hpp"

#include <algorithm>
#include <cmath>

#include "radio_channel/random.hpp"
#include "waves.hpp"

namespace tocsin::radio {

RicianFading::RicianFading(double wavelength_m, double doppler_hz, std::uint64_t seed) {
  RandomStream random(seed, 2);
  const double turn = random.uniform();
  for (std::size_t i = 0; i < wave_count; ++i) {
    const double direction = turn + (static_cast<double>(i) + random.uniform()) / wave_count;
    kx_[i] = cos_turns(direction) / wavelength_m;
    ky_[i] = cos_turns(direction - 0.25) / wavelength_m;
    doppler_[i] = doppler_hz * cos_turns(random.uniform());
    phase_[i] = random.uniform();
  }
  const double direction = random.uniform();
  direct_kx_ = cos_turns(direction) / wavelength_m;
  direct_ky_ = cos_turns(direction - 0.25) / wavelength_m;
  move_to(0, 0, 0);
}

void RicianFading::move_to(double x_m, double y_m, double k_db) {
  for (std::size_t i = 0; i < wave_count; ++i) {
    turns_[i] = fraction_of_turn(kx_[i] * x_m + ky_[i] * y_m + phase_[i]);
  }
  const double k = std::pow(10, k_db / 10);
  scattered_ = 1 / std::sqrt((k + 1) * wave_count);
  const double direct = std::sqrt(k / (k + 1));
  const double turns = direct_kx_ * x_m + direct_ky_ * y_m;
  direct_re_ = direct * cos_turns(turns);
  direct_im_ = direct * cos_turns(turns - 0.25);
}

double RicianFading::gain_db(double t_s) const {
  Lanes re{};
  Lanes im{};
  for (std::size_t i = 0; i < wave_count; i += lane_count) {
    Lanes turns;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      turns[lane] =
          static_cast<float>(fraction_of_turn(turns_[i + lane] + doppler_[i + lane] * t_s));
    }
    re += fast_cos_turns(turns);
    im += fast_sin_turns(turns);
  }
  const double real = direct_re_ + scattered_ * static_cast<double>(re[0] + re[1] + re[2] + re[3]);
  const double imaginary =
      direct_im_ + scattered_ * static_cast<double>(im[0] + im[1] + im[2] + im[3]);
  return 10 * std::log10(std::max(real * real + imaginary * imaginary, 1e-6));
}

}  // namespace tocsin::radio
