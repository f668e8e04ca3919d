// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "terminal/line.hpp"

namespace tocsin::terminal {

/// Room on a terminal, in characters.
struct Size {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// `size`, with 80 columns and 24 rows in place of a 0: what a terminal says that does not know.
[[nodiscard]] Size known(Size size);

/// The room of the terminal behind `descriptor` now; it may have another size the next time.
/// 80 x 24 when it does not know its size, or is no terminal. Any thread.
[[nodiscard]] Size size_of(int descriptor);

/// The first of `lines`, at most `room`; the last of them tells that there are more of what.
/// Nothing where there is no room for a head, one line and that.
[[nodiscard]] std::vector<Line> shortened(std::vector<Line> lines, std::size_t room,
                                          const std::string& what);

/// The first `size.rows` lines as text, each fitted into `size.columns`.
[[nodiscard]] std::vector<std::string> to_texts(const std::vector<Line>& lines, Size size,
                                                bool colour);

/// What replaces the content of an ANSI terminal of this size by `lines`, with colours. Every row
/// is written over, not the screen cleared, so that it does not flicker; the last one ends without
/// a new line, so that it does not scroll.
[[nodiscard]] std::string frame(const std::vector<Line>& lines, Size size);

}  // namespace tocsin::terminal
