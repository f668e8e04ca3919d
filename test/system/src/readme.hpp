// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin {

/// A fenced block of a Markdown page.
struct ReadmeBlock {
  std::string language;
  std::string file;  ///< the last `word` of the text since the block before; empty: none
  std::string text;
  int line;  ///< of its first line
};

/// The fenced blocks of a page in their order; none when it cannot be read.
[[nodiscard]] std::vector<ReadmeBlock> readme_blocks(const std::string& page);

/// What a person types in a block of language `console`, and what it prints.
struct ConsoleSession {
  std::string script;               ///< the lines after "$ "
  std::vector<std::string> prints;  ///< the others
};
[[nodiscard]] ConsoleSession console_session(const ReadmeBlock& block);

/// The first of the `wanted` lines that `output` does not have behind those before it; empty: it
/// has all, in their order, whatever is between. "..." stands for anything, one time of the day for
/// any other.
[[nodiscard]] std::string missing_line(const std::vector<std::string>& wanted,
                                       const std::string& output);

}  // namespace tocsin
