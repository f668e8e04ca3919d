// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "stack.hpp"

namespace tocsin {

/// What is done to the processes of a running launch.
enum class RealFault : std::uint8_t {
  kill,       ///< a process is killed with -9
  freeze,     ///< a process is stopped (SIGSTOP) and goes on after a while
  wlan0,      ///< the interface of the vehicle's radio is deleted, and made again after a while
  full_disk,  ///< the disk of the run folder has no room for a while
  cpu_hogs,   ///< two programs per core compute for a while
};
[[nodiscard]] inline constexpr std::array<const char*, 5> words_of(RealFault) {
  return {"kill", "freeze", "wlan0", "full_disk", "cpu_hogs"};
}

/// One of them, as it is to be done.
struct PlannedFault {
  RealFault fault = RealFault::kill;
  std::string target;           ///< process of kill and freeze; else empty
  std::chrono::seconds time{};  ///< that it lasts; a kill has none
};
/// "freeze uxv/drive 7 s".
[[nodiscard]] std::string to_text(const PlannedFault& planned);

/// The next fault for a launch with those processes: each kind as likely as any other.
[[nodiscard]] PlannedFault draw_fault(std::mt19937& random,
                                      const std::vector<std::string>& processes);

/// Does it, and returns when it is over. The target may be gone by itself, which is fine. `stack`
/// needs a disk of its own for full_disk. Nothing when it was done; else why it could not be.
[[nodiscard]] std::optional<std::string> inflict(const Stack& stack, const PlannedFault& planned);

}  // namespace tocsin
