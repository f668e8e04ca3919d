// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tocsin {

/// Text of others (from a file, a packet, a child process) as it may be shown: valid UTF-8 without
/// control characters, on one line, and of limited length.
///
/// Line breaks and tabs become `\n`, `\r`, `\t`; other control characters and bytes that are not
/// UTF-8 become `\x1b`; characters that cannot be seen or that reorder text become `\u202e`.
/// Everything else, also backslashes and quotes, stays, so that a text may pass twice. Of a text of
/// more than `longest` bytes only whole characters of its first `longest` bytes are shown, and its
/// size: `aaa... (1048576 bytes)`. Any thread.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest = 200);

/// `printable(text, longest)` as one cell of CSV (RFC 4180): in quotes when it holds a comma or a
/// quote. Each row is one line of the file.
[[nodiscard]] std::string csv_cell(std::string_view text, std::size_t longest = 4096);

/// The shortest text that reads back as the same number: `0.1`, `1e+308`, `nan`, `-inf`.
[[nodiscard]] std::string shortest_text(double value);

/// `value` with `decimals` places: `12.50`; from 1e9 on with an exponent: `1.00e+308` would have
/// 309 digits before its point otherwise.
[[nodiscard]] std::string fixed_text(double value, int decimals);

}  // namespace tocsin
