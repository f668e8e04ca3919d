// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::map_tool {

/// What `tocsin map order` is asked for.
struct OrderOptions {
  std::string mission;
  std::string map;
  std::string link;  ///< empty: the link is good everywhere
  std::string out;
  double most_detour = 0.15;
};

/// Writes the mission with its waypoints in an order that is short and keeps the link; the first
/// and the last one stay. What that saves as a line. Throws ConfigError.
[[nodiscard]] std::string order(const OrderOptions& options);

}  // namespace tocsin::map_tool
