// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace tocsin::bench {

/// What a piece of work took.
struct Measured {
  double wall_s = 0;
  double cpu_s = 0;  ///< of this process, user and system
};

[[nodiscard]] Measured measured(const std::function<void()>& work);

/// Prints a row: bytes and messages a second, by the clock and by the CPU time of one core.
void print_row(const std::string& name, const Measured& took, std::uint64_t bytes,
               std::uint64_t messages = 0);

/// [KiB] The most memory that this process had since it began or since the last reset.
[[nodiscard]] std::uint64_t peak_resident_kib();
void reset_peak();

/// Forgets what the kernel has cached of a file, so that it comes from the disk.
void drop_cache(const std::string& path);

}  // namespace tocsin::bench
