// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace tocsin {

/// The words for the values of an enum, in the order of their numbers from 0, as files and messages
/// spell them. An enum has them by `inline constexpr std::array words_of(Enum) {...}` beside it.
template <class Enum>
[[nodiscard]] constexpr const char* word_of(Enum value) {
  return words_of(Enum{})[static_cast<std::size_t>(value)];
}

/// The value of a word; empty when it is none.
template <class Enum>
[[nodiscard]] std::optional<Enum> value_of(std::string_view word) {
  constexpr auto words = words_of(Enum{});
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Enum>(found - words.begin());
}

/// Visits a parameter that is an enum as one of `allowed`, words of its values.
template <class Visitor, class Enum, class Allowed>
void visit_enum(Visitor& v, const char* name, Enum& value, const Allowed& allowed,
                const char* text) {
  std::string word = word_of(value);
  v(name, word, allowed, text);
  if constexpr (!std::is_const_v<Enum>) value = value_of<Enum>(word).value_or(value);
}

}  // namespace tocsin
