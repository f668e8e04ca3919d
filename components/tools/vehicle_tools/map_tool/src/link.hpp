// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin::map_tool {

/// What `tocsin map link` is asked for.
struct LinkOptions {
  std::string file;
  std::string columns;
  double leave_out = 0.25;
  std::optional<double> after;
  std::uint64_t seed = 1;
  bool json = false;
};

/// Learns a map of the link from a part of the places in a file and says how well it foretells the
/// others, beside the path loss alone and the nearest place. Throws ConfigError.
[[nodiscard]] std::string link(const LinkOptions& options);

}  // namespace tocsin::map_tool
