// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin {

/// The number that all of a text is; nothing for another text.
[[nodiscard]] inline std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && behind == end ? std::optional(number) : std::nullopt;
}

/// The number that all of an argument is, within [least, most]. Throws ConfigError with the
/// argument's name, its text and what is allowed.
[[nodiscard]] inline std::uint64_t whole_number(const std::string& text, const std::string& name,
                                                std::uint64_t least, std::uint64_t most) {
  const auto number = whole_number(text);
  if (number && *number >= least && *number <= most) return *number;
  throw ConfigError(name + ": '" + printable(text) + "' is no whole number of " +
                    std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace tocsin
