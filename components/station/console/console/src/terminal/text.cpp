// SPDX-License-Identifier: Apache-2.0
#include "terminal/text.hpp"

#include <locale.h>
#include <wchar.h>

#include <algorithm>

namespace tocsin::terminal {
namespace {

/// Makes UTF-8 the encoding of this thread as long as it lives, whatever the user's language is.
class Utf8 {
 public:
  Utf8() : before_(uselocale(locale())) {}
  ~Utf8() { uselocale(before_); }
  Utf8(const Utf8&) = delete;
  Utf8& operator=(const Utf8&) = delete;

 private:
  static locale_t locale() {
    static const locale_t made = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    return made;  // null, which changes nothing, where glibc is older than 2.35
  }
  locale_t before_;
};

struct Character {
  std::size_t bytes;
  std::size_t columns;
};

/// The first character of a text that is not empty. Only under `Utf8`.
Character first_of(std::string_view text) {
  mbstate_t state{};
  wchar_t character = 0;
  const std::size_t bytes = mbrtowc(&character, text.data(), text.size(), &state);
  if (bytes == 0 || bytes > text.size()) return {1, 1};  // a zero, or no character
  const int columns = wcwidth(character);
  return {bytes, columns < 0 ? 1 : static_cast<std::size_t>(columns)};
}

}  // namespace

std::size_t width_of(std::string_view text) {
  const Utf8 encoding;
  std::size_t width = 0;
  while (!text.empty()) {
    const Character character = first_of(text);
    width += character.columns;
    text.remove_prefix(character.bytes);
  }
  return width;
}

std::string cut(std::string_view text, std::size_t width) {
  if (width_of(text) <= width) return std::string(text);
  if (width == 0) return "";
  const Utf8 encoding;
  std::size_t bytes = 0;
  for (std::size_t columns = 1;;) {  // one is for the mark
    const Character character = first_of(text.substr(bytes));
    columns += character.columns;
    if (columns > width) break;
    bytes += character.bytes;
  }
  return std::string(text.substr(0, bytes)) + ">";
}

std::string padded(std::string_view text, std::size_t width, Align align) {
  std::string shown = cut(text, width);
  const std::string blanks(width - width_of(shown), ' ');
  return align == Align::left ? shown + blanks : blanks + shown;
}

}  // namespace tocsin::terminal
