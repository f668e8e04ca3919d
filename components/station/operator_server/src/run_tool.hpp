// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::foxglove {

struct ToolLimits {
  Duration time = std::chrono::seconds(10);
  std::size_t bytes = std::size_t{32} << 20U;  ///< of what it prints
};

/// What a program has done.
struct ToolOutcome {
  enum class End { success, failure, too_long, too_much, cancelled };
  End end = End::failure;
  std::string printed;  ///< on stdout and stderr
};

/// Runs a program to its end, or kills it at a limit or as soon as `cancelled`. Blocks until then.
[[nodiscard]] ToolOutcome run_tool(const std::vector<std::string>& command,
                                   const ToolLimits& limits, const std::atomic<bool>& cancelled);

}  // namespace tocsin::foxglove
