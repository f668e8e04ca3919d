// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::foxglove {

/// The page of one vehicle of a fleet.
struct FleetPage {
  std::string vehicle;
  std::string url;     ///< `http://127.0.0.1:8761/`
  std::string origin;  ///< the same as browsers name it: without the path
};

/// Reads "uxv1=http://127.0.0.1:8761/" and so on. Throws ConfigError naming `owner`.fleet and the
/// item. Pure.
[[nodiscard]] std::vector<FleetPage> fleet_pages(const std::string& owner,
                                                 const std::vector<std::string>& items);

/// As the fleet's page reads it.
[[nodiscard]] std::string fleet_text(const std::vector<FleetPage>& pages);

}  // namespace tocsin::foxglove
