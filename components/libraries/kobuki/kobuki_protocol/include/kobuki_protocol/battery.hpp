// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tocsin::kobuki {

struct BatteryParams {
  double capacity_v = 16.5;
  double low_v = 14.0;
  double dangerous_v = 13.2;
  template <class Visitor>
  void visit(Visitor& v) {
    v("battery_capacity_v", capacity_v, {10, 20}, "[V] full battery");
    v("battery_low_v", low_v, {10, 20}, "[V] at or below: low");
    v("battery_dangerous_v", dangerous_v, {10, 20}, "[V] at or below: dangerous");
  }
};

enum class ChargingState : std::uint8_t { discharging, charged, charging };
enum class ChargingSource : std::uint8_t { none, adapter, dock };
enum class BatteryLevel : std::uint8_t { dangerous, low, healthy, maximum };

struct Battery {
  double voltage_v = 0;
  double percentage = 0;  ///< [1] 0 to 1
  ChargingState state = ChargingState::discharging;
  ChargingSource source = ChargingSource::none;
  BatteryLevel level = BatteryLevel::dangerous;
};

/// Reads the battery and charger bytes (reference page 1.7). One formula of voltage for all
/// sources; unlike the reference driver, "charged" changes no parameter.
class BatteryReader {
 public:
  /// Throws ConfigError unless dangerous < low < capacity.
  explicit BatteryReader(const BatteryParams& params);
  [[nodiscard]] Battery read(std::uint8_t battery_dv, std::uint8_t charger) const;

 private:
  BatteryParams params_;
};

/// From the low nibble; values that nobody documented count as discharging.
[[nodiscard]] ChargingState charging_state(std::uint8_t charger);
[[nodiscard]] ChargingSource charging_source(std::uint8_t charger);

}  // namespace tocsin::kobuki
