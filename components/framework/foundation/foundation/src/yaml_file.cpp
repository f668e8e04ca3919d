// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_file.hpp"

namespace tocsin {

YAML::Node read_yaml_file(const std::string& path) { return YamlSources().read(path); }

YAML::Node read_yaml_text(const std::string& text, const std::string& name) {
  return YamlSources().parse(text, name);
}

std::string yaml_place(const YamlSources& sources, const YAML::Node& node) {
  return " (" + sources.place(node) + ")";
}

}  // namespace tocsin
