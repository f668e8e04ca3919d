// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/device_files.hpp"

namespace tocsin::telemetry {

/// A temperature input of the kernel.
struct Thermometer {
  std::string name;  ///< `type` of a thermal zone, `name` of a hwmon device
  std::string file;  ///< holds the temperature in thousandths of a degree
};

/// The temperature in a sensor's file [degC]. Empty when it is no number, or outside [-60, 200],
/// which no working CPU has.
[[nodiscard]] std::optional<double> parse_temperature(const std::string& text);

/// The one that measures the CPU; empty when none says that it does. Of several the most specific
/// wins: package or die sensors before the board's.
[[nodiscard]] std::optional<Thermometer> choose_cpu_thermometer(
    const std::vector<Thermometer>& thermometers);

/// All thermometers below /sys/class/thermal and /sys/class/hwmon (or folders of the same form).
/// A missing folder has none.
[[nodiscard]] std::vector<Thermometer> list_thermometers(DeviceFiles& files,
                                                         const std::string& thermal_dir,
                                                         const std::string& hwmon_dir);

}  // namespace tocsin::telemetry
