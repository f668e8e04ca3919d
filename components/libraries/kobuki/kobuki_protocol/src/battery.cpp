// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/battery.hpp"

#include <algorithm>
#include <string>

#include "foundation/error.hpp"

namespace tocsin::kobuki {

BatteryReader::BatteryReader(const BatteryParams& params) : params_(params) {
  if (params.dangerous_v < params.low_v && params.low_v < params.capacity_v) return;
  throw ConfigError(
      "battery: must be battery_dangerous_v < battery_low_v < battery_capacity_v, but is " +
      std::to_string(params.dangerous_v) + ", " + std::to_string(params.low_v) + ", " +
      std::to_string(params.capacity_v));
}

ChargingState charging_state(std::uint8_t charger) {
  switch (charger & 0x0FU) {
    case 2:
      return ChargingState::charged;
    case 6:
      return ChargingState::charging;
    default:
      return ChargingState::discharging;
  }
}

ChargingSource charging_source(std::uint8_t charger) {
  if (charging_state(charger) == ChargingState::discharging) return ChargingSource::none;
  return (charger & 0x10U) != 0 ? ChargingSource::adapter : ChargingSource::dock;
}

Battery BatteryReader::read(std::uint8_t battery_dv, std::uint8_t charger) const {
  Battery battery;
  battery.voltage_v = battery_dv / 10.0;
  const double above_v = battery.voltage_v - params_.dangerous_v;
  const double span_v = params_.capacity_v - params_.dangerous_v;
  battery.percentage = std::clamp(0.95 * above_v / span_v + 0.05, 0.0, 1.0);
  battery.state = charging_state(charger);
  battery.source = charging_source(charger);
  if (battery.state == ChargingState::charged) {
    battery.level = BatteryLevel::maximum;
  } else if (battery.voltage_v > params_.low_v) {
    battery.level = BatteryLevel::healthy;
  } else if (battery.voltage_v > params_.dangerous_v) {
    battery.level = BatteryLevel::low;
  }
  return battery;
}

}  // namespace tocsin::kobuki
