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
}

double RicianFading::gain_db(double k_db, double x_m, double y_m, double t_s) const {
  Waves real;
  Waves imaginary;
  for (std::size_t i = 0; i < wave_count; ++i) {
    const double turns = kx_[i] * x_m + ky_[i] * y_m + doppler_[i] * t_s + phase_[i];
    real[i] = cos_turns(turns);
    imaginary[i] = cos_turns(turns - 0.25);
  }
  double re = 0;
  double im = 0;
  for (std::size_t i = 0; i < wave_count; ++i) {
    re += real[i];
    im += imaginary[i];
  }
  const double k = std::pow(10, k_db / 10);
  const double scattered = 1 / std::sqrt((k + 1) * wave_count);
  const double direct = std::sqrt(k / (k + 1));
  const double direct_turns = direct_kx_ * x_m + direct_ky_ * y_m;
  re = re * scattered + direct * cos_turns(direct_turns);
  im = im * scattered + direct * cos_turns(direct_turns - 0.25);
  return 10 * std::log10(std::max(re * re + im * im, 1e-6));
}

}  // namespace tocsin::radio
