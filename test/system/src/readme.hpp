// SPDX-License-Identifier: Apache-2.0
// Pages of Markdown whose files and commands are tested as they stand there.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"

namespace tocsin {

/// A fenced block of a page.
struct ReadmeBlock {
  std::string language;
  std::string file;  ///< the last `word` of the text since the block before; empty: none
  std::string text;
  int line;  ///< of its first line
};

/// What a person types in a block of language `console`, and what it prints.
struct ConsoleSession {
  std::string script;               ///< the lines after "$ "
  std::vector<std::string> prints;  ///< the others
  int line;
};

/// The fenced blocks of a page in their order, but for its console sessions; none when the page
/// cannot be read.
[[nodiscard]] std::vector<ReadmeBlock> readme_files(const std::string& page);
[[nodiscard]] std::vector<ConsoleSession> readme_sessions(const std::string& page);

/// The first of the `wanted` lines that `output` does not have behind those before it; empty: it
/// has all, in their order, whatever is between. "..." stands for anything, one time of the day for
/// any other.
[[nodiscard]] std::string missing_line(const std::vector<std::string>& wanted,
                                       const std::string& output);

/// Runs a session by bash in `folder`, after the lines of `prelude`, until it has printed all that
/// it should or `limit` is over; then ends what still runs. What went wrong; empty: nothing.
[[nodiscard]] std::string play(const ConsoleSession& session, const TemporaryFolder& folder,
                               const std::string& prelude, std::chrono::seconds limit);

}  // namespace tocsin
