// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "kobuki_model/model_params.hpp"
#include "kobuki_protocol/battery.hpp"

namespace tocsin::kobuki {

/// The battery: charge drains with the load and rises at a charger; voltage follows charge and
/// load.
class Power {
 public:
  explicit Power(const ModelParams& params);
  /// `motor_a` is the current of both motors.
  void step(double dt_s, double motor_a);
  void plug(ChargingSource source) { source_ = source; }
  /// 0 to 1; other values are clamped.
  void set_charge(double charge);

  [[nodiscard]] double charge() const { return charge_; }
  [[nodiscard]] ChargingSource source() const { return source_; }
  /// The battery byte (0.1 V) and the charger byte of core sensors.
  [[nodiscard]] std::uint8_t battery_dv() const;
  [[nodiscard]] std::uint8_t charger() const;

 private:
  ModelParams params_;
  ChargingSource source_ = ChargingSource::none;
  double charge_;
  double load_a_ = 0;
};

}  // namespace tocsin::kobuki
