// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/power.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::kobuki {
namespace {

// A 4S Li-ion pack: 13.0 V empty, 16.6 V full, between the limits of reference page 1.7.
constexpr double empty_v = 13.0;
constexpr double full_v = 16.6;
constexpr double resistance_ohm = 0.15;
constexpr double idle_a = 0.5;
constexpr double charging_a = 1.5;

}  // namespace

Power::Power(const ModelParams& params) : params_(params), charge_(params.battery_charge) {}

void Power::set_charge(double charge) { charge_ = std::clamp(charge, 0.0, 1.0); }

void Power::step(double dt_s, double motor_a) {
  load_a_ = idle_a + motor_a;
  const double current_a = source_ == ChargingSource::none ? -load_a_ : charging_a;
  const double change_ah = current_a * params_.battery_drain_scale * dt_s / 3600.0;
  set_charge(charge_ + change_ah / params_.battery_capacity_ah);
}

std::uint8_t Power::battery_dv() const {
  const double drop_v = source_ == ChargingSource::none ? resistance_ohm * load_a_ : 0;
  const double voltage_v = empty_v + (full_v - empty_v) * charge_ - drop_v;
  return static_cast<std::uint8_t>(std::lround(10.0 * voltage_v));
}

std::uint8_t Power::charger() const {
  if (source_ == ChargingSource::none) return 0;
  const unsigned state = charge_ >= 1.0 ? 2 : 6;
  return static_cast<std::uint8_t>(source_ == ChargingSource::adapter ? state | 0x10U : state);
}

}  // namespace tocsin::kobuki
