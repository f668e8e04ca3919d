// SPDX-License-Identifier: Apache-2.0
#include "foundation/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

/// Seen as they are: no escape in any terminal and in any encoding.
bool is_plain(char c) { return c >= ' ' && c <= '~'; }

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The first `longest` bytes without a character that is cut at their end.
std::string_view head_of(std::string_view text, std::size_t longest) {
  std::size_t end = longest;
  while (end > 0 && longest - end < 4 && continues_character(text[end])) --end;
  return text.substr(0, continues_character(text[end]) ? longest : end);
}

/// fmt's debug form is the escaped text in quotes; backslashes and quotes are escaped there, too.
std::string escaped(std::string_view text) {
  const std::string quoted = fmt::format("{:?}", text);
  std::string out;
  for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
    if (quoted[i] == '\\' && (quoted[i + 1] == '\\' || quoted[i + 1] == '"')) ++i;
    out += quoted[i];
  }
  return out;
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  if (text.size() > longest) {
    return printable(head_of(text, longest), longest) + fmt::format("... ({} bytes)", text.size());
  }
  return std::all_of(text.begin(), text.end(), is_plain) ? std::string(text) : escaped(text);
}

std::string csv_cell(std::string_view text, std::size_t longest) {
  const std::string shown = printable(text, longest);
  if (shown.find_first_of(",\"") == std::string::npos) return shown;
  std::string cell = "\"";
  for (const char c : shown) {
    if (c == '"') cell += '"';
    cell += c;
  }
  return cell + '"';
}

std::string shortest_text(double value) { return fmt::format("{}", value); }

std::string fixed_text(double value, int decimals) {
  constexpr double longest_fixed = 1e9;
  if (std::abs(value) < longest_fixed) return fmt::format("{:.{}f}", value, decimals);
  return fmt::format("{:.{}e}", value, decimals);
}

}  // namespace tocsin
