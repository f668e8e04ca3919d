// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace tocsin::telemetry {

/// Takes the first line, without its end, off the front of `text`.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// Takes the first word off the front of `text`; empty when there is none.
[[nodiscard]] std::string_view take_word(std::string_view& text);

/// The number, in decimal digits, that is the whole of `word`; empty when it is none or too large.
template <class Number>
[[nodiscard]] std::optional<Number> whole_number(std::string_view word) {
  Number number{};
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, number);
  return error == std::errc{} && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace tocsin::telemetry
