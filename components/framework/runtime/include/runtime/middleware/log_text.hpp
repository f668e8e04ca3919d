// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

namespace tocsin {

/// Where a line of the log is written in the source.
struct LogPlace {
  const char* file = "";  ///< as the compiler was given it
  const char* function = "";
  unsigned line = 0;
};

/// The text of a line, and by itself the place of who gives it.
template <class... Args>
struct LogText {
  template <class Text>
  constexpr LogText(const Text& given,  // NOLINT(google-explicit-constructor): a text is one
                    const char* file = __builtin_FILE(),
                    const char* function = __builtin_FUNCTION(), unsigned line = __builtin_LINE())
      : text(given), place{file, function, line} {}
  fmt::format_string<Args...> text;
  LogPlace place;
};

/// What keeps the arguments of a line from being found in its text.
template <class... Args>
struct LogTextOf {
  using type = LogText<Args...>;
};
template <class... Args>
using LogTextFor = typename LogTextOf<Args...>::type;

}  // namespace tocsin
