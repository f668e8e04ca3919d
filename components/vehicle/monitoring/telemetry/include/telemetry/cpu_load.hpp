// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tocsin::telemetry {

/// Time that CPUs have spent since boot, in the kernel's ticks (all that matters are ratios).
struct CpuTimes {
  std::uint64_t busy = 0;
  std::uint64_t idle = 0;  ///< idle, or waiting for input and output
};

/// One look at /proc/stat.
struct CpuSnapshot {
  CpuTimes all;
  std::map<int, CpuTimes> cores;  ///< by the kernel's number; a core that is off is missing
};

/// The text of /proc/stat. Empty when the line of all CPUs is missing or damaged; a damaged line
/// of a core is left out. Guest time is not added: the kernel counts it as user time as well.
[[nodiscard]] std::optional<CpuSnapshot> parse_proc_stat(const std::string& text);

/// Share of the time that was not idle.
struct CpuLoad {
  double all_percent = 0;             ///< [%] [0, 100]
  std::vector<double> cores_percent;  ///< [%] [0, 100] by ascending number
};

/// Load between two looks. Pure.
class CpuLoadMeter {
 public:
  /// The load since the last call. Empty at the first one, and when no time has passed. A core that
  /// has just come on is left out once.
  [[nodiscard]] std::optional<CpuLoad> update(const CpuSnapshot& snapshot);

 private:
  std::optional<CpuSnapshot> last_;
};

}  // namespace tocsin::telemetry
