// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tocsin::cli {

constexpr std::size_t longest_line = 8192;  ///< [byte]

/// Cuts the bytes of a pipe into lines, however they arrive.
class LineSplitter {
 public:
  /// The lines that `bytes` completes, without their ends. One of more than `longest_line` bytes
  /// comes in pieces of that size.
  [[nodiscard]] std::vector<std::string> feed(std::string_view bytes);
  /// The unfinished last line; empty when there is none.
  [[nodiscard]] std::string rest();

 private:
  std::string partial_;
};

/// `[name] text`, the name in one of six colours chosen by `colour`; plain without.
[[nodiscard]] std::string prefixed(const std::string& name, const std::string& text,
                                   std::optional<int> colour);

}  // namespace tocsin::cli
