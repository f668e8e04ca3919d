// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tocsin::terminal {

/// Columns that `text` (UTF-8 without control characters, see `printable`) takes on a terminal:
/// two for each wide character, none for a combining one (Unicode, as glibc's `wcwidth` knows it).
/// A byte that is not UTF-8 counts as one.
[[nodiscard]] std::size_t width_of(std::string_view text);

/// `text`, or the whole characters of its beginning that fit in `width` columns with a `>` behind
/// them that says that it goes on. Empty for a width of 0.
[[nodiscard]] std::string cut(std::string_view text, std::size_t width);

enum class Align { left, right };

/// `cut(text, width)` with blanks up to `width` columns.
[[nodiscard]] std::string padded(std::string_view text, std::size_t width, Align align);

}  // namespace tocsin::terminal
