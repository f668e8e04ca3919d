// SPDX-License-Identifier: Apache-2.0
#include "telemetry/cpu_temperature.hpp"

#include <algorithm>
#include <array>

#include "telemetry/words.hpp"

namespace tocsin::telemetry {
namespace {

/// Names that kernel drivers give to CPU sensors, best first: Intel package, Intel and AMD hwmon,
/// ARM SoCs (Raspberry Pi: cpu-thermal), ACPI last, which is often the board.
constexpr std::array sensors{"x86_pkg_temp", "coretemp",    "k10temp",      "zenpower",
                             "cpu-thermal",  "cpu_thermal", "cpu0-thermal", "soc-thermal",
                             "soc_thermal",  "CPU-therm",   "acpitz"};

std::string trimmed(std::string text) {
  constexpr auto blank = " \t\r\n";
  text.erase(text.find_last_not_of(blank) + 1);
  text.erase(0, text.find_first_not_of(blank));
  return text;
}

/// The names of a thermometer's files.
struct Names {
  const char* name;
  const char* value;
};

/// One thermometer per sub-folder that has both files; a sensor that fails counts.
void list_devices(DeviceFiles& files, const std::string& folder, const Names& names,
                  std::vector<Thermometer>& found) {
  for (const std::string& entry : files.list(folder)) {
    const std::string device = folder + "/" + entry;
    const auto name = files.read(device + "/" + names.name);
    const auto inside = files.list(device);
    const bool has_value = std::find(inside.begin(), inside.end(), names.value) != inside.end();
    if (name && has_value) found.push_back({trimmed(*name), device + "/" + names.value});
  }
}

}  // namespace

std::optional<double> parse_temperature(const std::string& text) {
  const auto millidegrees = whole_number<long long>(trimmed(text));
  if (!millidegrees || *millidegrees < -60'000 || *millidegrees > 200'000) return std::nullopt;
  return static_cast<double>(*millidegrees) / 1000.0;
}

std::optional<Thermometer> choose_cpu_thermometer(const std::vector<Thermometer>& thermometers) {
  for (const char* name : sensors) {
    const auto found = std::find_if(thermometers.begin(), thermometers.end(),
                                    [name](const Thermometer& t) { return t.name == name; });
    if (found != thermometers.end()) return *found;
  }
  return std::nullopt;
}

std::vector<Thermometer> list_thermometers(DeviceFiles& files, const std::string& thermal_dir,
                                           const std::string& hwmon_dir) {
  std::vector<Thermometer> found;
  list_devices(files, thermal_dir, {"type", "temp"}, found);
  list_devices(files, hwmon_dir, {"name", "temp1_input"}, found);
  // The order of a folder's entries is the file system's; ours is not.
  std::sort(found.begin(), found.end(),
            [](const Thermometer& a, const Thermometer& b) { return a.file < b.file; });
  return found;
}

}  // namespace tocsin::telemetry
