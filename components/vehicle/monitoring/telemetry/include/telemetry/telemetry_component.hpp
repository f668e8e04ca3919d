// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "telemetry/cpu_load.hpp"
#include "telemetry/cpu_temperature.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Reports how the on-board computer is: memory, CPU load, CPU temperature.
class TelemetryComponent final : public Component {
 public:
  struct Params {
    double period_s = 1.0;
    std::string meminfo_file = "/proc/meminfo";
    std::string stat_file = "/proc/stat";
    std::string thermal_dir = "/sys/class/thermal";
    std::string hwmon_dir = "/sys/class/hwmon";

    template <class Visitor>
    void visit(Visitor& v) {
      v("period_s", period_s, {0.1, 60}, "[s] time between two reports");
      v("meminfo_file", meminfo_file, "source of the memory, format of /proc/meminfo");
      v("stat_file", stat_file, "source of the CPU load, format of /proc/stat");
      v("thermal_dir", thermal_dir, "thermal zones to look for the CPU's");
      v("hwmon_dir", hwmon_dir, "hardware monitors to look for the CPU's");
    }
  };

  TelemetryComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void report_memory(Time now);
  void report_load(Time now);
  void report_temperature(Time now);
  void say_once(const std::string& text);

  Output<topic::MemoryUsage> memory_{*this};
  Output<topic::CpuLoad> load_{*this};
  Output<topic::CpuTemperature> temperature_{*this};
  Params params_;
  std::unique_ptr<DeviceFiles> files_;
  telemetry::CpuLoadMeter meter_;
  std::optional<telemetry::Thermometer> thermometer_;
  std::set<std::string> said_;
};

}  // namespace tocsin
