// SPDX-License-Identifier: Apache-2.0
#include "auto_docking/light_sweep.hpp"

#include <cmath>

namespace tocsin {
namespace {

constexpr int dark_updates = 20;  // 0.4 s: receivers miss single signals

}  // namespace

void LightSweep::update(double heading_rad, std::uint8_t signals) {
  if (complete_) return;
  if (signals != 0) {
    dark_for_ = 0;
    cos_sum_ += std::cos(heading_rad);
    sin_sum_ += std::sin(heading_rad);
    signals_ = static_cast<std::uint8_t>(signals_ | signals);
    return;
  }
  if (++dark_for_ < dark_updates) return;
  if (signals_ != 0) return pass();
  began_dark_ = true;
}

void LightSweep::pass() {
  if (began_dark_) {
    complete_ = true;
    return;
  }
  turn_ = turn_ == Turn::left ? Turn::right : Turn::left;
  began_dark_ = true;
  cos_sum_ = sin_sum_ = 0;
  signals_ = 0;
}

double LightSweep::bearing_rad() const { return std::atan2(sin_sum_, cos_sum_); }

}  // namespace tocsin
