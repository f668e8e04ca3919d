// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin::telemetry {

/// Main memory of the computer.
struct Memory {
  std::uint64_t total_bytes = 0;      ///< never 0
  std::uint64_t available_bytes = 0;  ///< what programs can still get without swapping
  /// [%] [0, 100]
  [[nodiscard]] double used_percent() const;
};

/// The text of /proc/meminfo. Empty when total or available memory (Linux 3.14) is not in it.
[[nodiscard]] std::optional<Memory> parse_meminfo(const std::string& text);

}  // namespace tocsin::telemetry
