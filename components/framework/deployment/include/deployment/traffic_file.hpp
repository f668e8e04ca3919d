// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/yaml_sources.hpp"

namespace tocsin::deployment {

/// Reads a file of traffic classes, role by role, with the files that it extends: the topics,
/// services and actions of a class come to those that the base has there, and leave the class that
/// they have had. `share` is
/// the installed share/tocsin folder. Throws ConfigError.
[[nodiscard]] YAML::Node read_traffic_file(const std::string& path, const std::string& share,
                                           YamlSources& sources);

}  // namespace tocsin::deployment
