// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin {

/// How a program ended.
struct Ended {
  int code = 0;        ///< exit code; 128 and more for a signal
  std::string output;  ///< all that it wrote to stdout and stderr, in the order of its writes
};

/// What a program finds when it starts.
struct ProgramInput {
  std::string text;    ///< what it reads from stdin
  std::string folder;  ///< where it runs; empty: where this process does
};

/// Runs a program to its end, without a shell: its path, or a name that is looked for in PATH, and
/// its arguments. Blocks until then. Throws EnvironmentError when it cannot be executed.
[[nodiscard]] Ended run_to_end(const std::vector<std::string>& command,
                               const ProgramInput& input = {});

}  // namespace tocsin
