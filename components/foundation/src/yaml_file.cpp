// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_file.hpp"

#include <fstream>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin {

YAML::Node read_yaml_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf()).good()) {
    throw ConfigError(path + ": cannot be read, or is empty");
  }
  try {
    return YAML::Load(text.str());
  } catch (const YAML::ParserException& error) {
    throw ConfigError(path + ":" + std::to_string(error.mark.line + 1) +
                      ": not valid YAML: " + error.msg);
  }
}

std::string yaml_place(const std::string& path, const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  if (mark.is_null()) return " (" + path + ")";
  return " (" + path + ":" + std::to_string(mark.line + 1) + ")";
}

}  // namespace tocsin
