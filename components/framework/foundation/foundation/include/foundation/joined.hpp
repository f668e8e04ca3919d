// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tocsin {

/// What `text_of` makes of each of them, with a text between.
///
/// In place of fmt::join, whose code GCC 12 takes for an overflow when it joins texts at -O3.
template <class Range, class TextOf>
[[nodiscard]] std::string joined_of(const Range& range, const TextOf& text_of,
                                    std::string_view between = ", ") {
  std::string text;
  bool first = true;
  for (const auto& one : range) {
    if (!first) text += between;
    text += text_of(one);
    first = false;
  }
  return text;
}

[[nodiscard]] inline std::string joined(const std::vector<std::string>& texts,
                                        std::string_view between = ", ") {
  return joined_of(
      texts, [](const std::string& text) -> const std::string& { return text; }, between);
}

}  // namespace tocsin
