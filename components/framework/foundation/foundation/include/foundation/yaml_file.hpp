// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "foundation/yaml_sources.hpp"

namespace tocsin {

/// YamlSources().read(path), for who needs no places of nodes but within errors of one file.
[[nodiscard]] YAML::Node read_yaml_file(const std::string& path);

/// YamlSources().parse(text, name).
[[nodiscard]] YAML::Node read_yaml_text(const std::string& text, const std::string& name);

/// " (file:line)" of a node, for error texts; only " (file)" when the node has no position.
[[nodiscard]] std::string yaml_place(const YamlSources& sources, const YAML::Node& node);

}  // namespace tocsin
