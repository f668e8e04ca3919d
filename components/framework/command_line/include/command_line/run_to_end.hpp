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

/// Runs a program, the path in front of its arguments, to its end; it has no input. Throws
/// EnvironmentError when it cannot be executed.
[[nodiscard]] Ended run_to_end(const std::vector<std::string>& command);

}  // namespace tocsin
