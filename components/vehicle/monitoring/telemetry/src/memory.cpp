// SPDX-License-Identifier: Apache-2.0
#include "telemetry/memory.hpp"

#include <algorithm>
#include <string_view>

#include "telemetry/words.hpp"

namespace tocsin::telemetry {
namespace {

/// The value of "key:   1234 kB"; empty when it is none.
std::optional<std::uint64_t> bytes_of(std::string_view line, std::string_view key) {
  constexpr std::uint64_t unit = 1024;  // "kB" of the kernel
  constexpr std::uint64_t largest = UINT64_MAX / unit;
  if (line.substr(0, key.size()) != key) return std::nullopt;
  line.remove_prefix(key.size());
  const auto value = whole_number<std::uint64_t>(take_word(line));
  if (!value || *value > largest || take_word(line) != "kB") return std::nullopt;
  return *value * unit;
}

}  // namespace

double Memory::used_percent() const {
  const std::uint64_t available = std::min(available_bytes, total_bytes);
  return 100.0 * static_cast<double>(total_bytes - available) / static_cast<double>(total_bytes);
}

std::optional<Memory> parse_meminfo(const std::string& text) {
  std::optional<std::uint64_t> total, available;
  for (std::string_view rest = text; !rest.empty() && !(total && available);) {
    const std::string_view line = take_line(rest);
    if (!total) total = bytes_of(line, "MemTotal:");
    if (!available) available = bytes_of(line, "MemAvailable:");
  }
  if (!total || !available || *total == 0) return std::nullopt;
  return Memory{*total, *available};
}

}  // namespace tocsin::telemetry
