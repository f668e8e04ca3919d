// SPDX-License-Identifier: Apache-2.0
#include "line_splitter.hpp"

#include <utility>

namespace tocsin::cli {

std::vector<std::string> LineSplitter::feed(std::string_view bytes) {
  std::vector<std::string> lines;
  for (const char byte : bytes) {
    if (byte != '\n') partial_ += byte;
    if (byte != '\n' && partial_.size() < longest_line) continue;
    if (!partial_.empty() && partial_.back() == '\r') partial_.pop_back();
    lines.push_back(std::exchange(partial_, {}));
  }
  return lines;
}

std::string LineSplitter::rest() { return std::exchange(partial_, {}); }

std::string prefixed(const std::string& name, const std::string& text, std::optional<int> colour) {
  if (!colour) return "[" + name + "] " + text;
  const std::string code = std::to_string(31 + *colour % 6);  // ANSI red to cyan
  return "\033[" + code + "m[" + name + "]\033[0m " + text;
}

}  // namespace tocsin::cli
