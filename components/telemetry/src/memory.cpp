// SPDX-License-Identifier: Apache-2.0
#include "telemetry/memory.hpp"

#include <algorithm>
#include <sstream>

namespace tocsin::telemetry {
namespace {

/// The value of "key:   1234 kB"; empty when it is none.
std::optional<std::uint64_t> bytes_of(const std::string& line, const std::string& key) {
  constexpr std::uint64_t unit = 1024;  // "kB" of the kernel
  constexpr std::uint64_t largest = UINT64_MAX / unit;
  if (line.compare(0, key.size(), key) != 0) return std::nullopt;
  std::istringstream in(line.substr(key.size()));
  std::uint64_t value = 0;
  std::string word;
  const bool whole = (in >> value >> word) && word == "kB" && value <= largest;
  // A stream reads "-1" into an unsigned number without complaint.
  if (!whole || line.find('-') != std::string::npos) return std::nullopt;
  return value * unit;
}

}  // namespace

double Memory::used_percent() const {
  const std::uint64_t available = std::min(available_bytes, total_bytes);
  return 100.0 * static_cast<double>(total_bytes - available) / static_cast<double>(total_bytes);
}

std::optional<Memory> parse_meminfo(const std::string& text) {
  std::optional<std::uint64_t> total, available;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!total) total = bytes_of(line, "MemTotal:");
    if (!available) available = bytes_of(line, "MemAvailable:");
  }
  if (!total || !available || *total == 0) return std::nullopt;
  return Memory{*total, *available};
}

}  // namespace tocsin::telemetry
