// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "section.hpp"

namespace tocsin::deployment {

/// One of `vehicles` of a bringup file.
struct VehicleEntry {
  std::string name;
  std::string address;                 ///< IPv4, on the link; empty behind a relay
  std::vector<std::string> variables;  ///< names of its own
};

/// Empty when the file has no `vehicles`. With a relay none has an address, else all have one.
/// Throws ConfigError.
[[nodiscard]] std::vector<VehicleEntry> read_vehicles(const YAML::Node& root, bool is_relay,
                                                      const YamlSources& sources);

/// The texts of a map `variables`, empty when it is absent. Throws ConfigError for a name that
/// means something already.
[[nodiscard]] Variables read_variables(const Section& section, const YamlSources& sources);

/// The name of the one host that is a vehicle, which all `vehicles` are like. Throws ConfigError
/// when there is none, or another one.
[[nodiscard]] std::string vehicle_host(const YAML::Node& root, const YamlSources& sources);

/// Leaves of a file with `vehicles` what is there once: without the host of vehicle_host, unless it
/// is a relay, and the containers that are `each_vehicle`.
void keep_common(const YAML::Node& root, bool is_relay, const YamlSources& sources);

/// Leaves of it what is there for each vehicle: that host, and those containers of the others. With
/// a relay those containers of all.
void keep_own(const YAML::Node& root, bool is_relay, const YamlSources& sources);

}  // namespace tocsin::deployment
