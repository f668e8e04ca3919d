// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rewrite.hpp"

namespace tocsin::bag_tool {

/// What came of an export.
struct Exported {
  std::uint64_t messages = 0;
  std::uint64_t lost = 0;  ///< rows for which there was no room
  /// Topics of which there is only a row for each message, as no installed library has their type.
  std::vector<std::string> unknown;
  std::vector<std::string> problems;  ///< what could not be made, a line each
};

/// Writes the wanted messages of a bag as CSV into the folder `order.output`, as the recorder does.
/// Throws ConfigError for what is no bag, and when the folder is there already.
[[nodiscard]] Exported export_csv(const RewriteOrder& order);

}  // namespace tocsin::bag_tool
