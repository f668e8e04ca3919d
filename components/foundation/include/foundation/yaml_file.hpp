// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "foundation/yaml_sources.hpp"

namespace tocsin {

/// Reads one YAML document. Throws ConfigError with file, line and reason when the file cannot be
/// read or is not YAML.
[[nodiscard]] YAML::Node read_yaml_file(const std::string& path);

/// " (file:line)" of a node, for error texts; only " (file)" when the node has no position.
[[nodiscard]] std::string yaml_place(const YamlSources& sources, const YAML::Node& node);

}  // namespace tocsin
