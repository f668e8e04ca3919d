// SPDX-License-Identifier: Apache-2.0
#include "terminal/screen.hpp"

#include <sys/ioctl.h>

namespace tocsin::terminal {

Size known(Size size) {
  constexpr Size usual;
  return {size.columns > 0 ? size.columns : usual.columns, size.rows > 0 ? size.rows : usual.rows};
}

Size size_of(int descriptor) {
  winsize told{};
  if (::ioctl(descriptor, TIOCGWINSZ, &told) != 0) return {};
  return known({told.ws_col, told.ws_row});
}

std::vector<Line> shortened(std::vector<Line> lines, std::size_t room, const std::string& what) {
  if (lines.size() <= room) return lines;
  constexpr std::size_t least = 3;
  if (room < least) return {};
  const std::size_t hidden = lines.size() - (room - 1);
  lines.resize(room - 1);
  lines.push_back({{"and " + std::to_string(hidden) + " " + what + " more", Style::old}});
  return lines;
}

std::vector<std::string> to_texts(const std::vector<Line>& lines, Size size, bool colour) {
  const Size room = known(size);
  std::vector<std::string> texts;
  for (const Line& line : lines) {
    if (texts.size() == room.rows) break;
    texts.push_back(to_text(line, room.columns, colour));
  }
  return texts;
}

std::string frame(const std::vector<Line>& lines, Size size) {
  constexpr const char* home = "\x1b[H";
  constexpr const char* next_row = "\r\n";
  // Before the text: behind a text that fills the row it would take the last character away.
  constexpr const char* clear_row = "\x1b[2K";
  constexpr const char* clear_below = "\x1b[J";
  const std::vector<std::string> texts = to_texts(lines, size, true);
  std::string sequence = home;
  for (const std::string& text : texts) {
    if (&text != &texts.front()) sequence += next_row;
    sequence += clear_row + text;
  }
  if (texts.size() == known(size).rows) return sequence;
  return sequence + (texts.empty() ? "" : next_row) + clear_below;
}

}  // namespace tocsin::terminal
