// SPDX-License-Identifier: Apache-2.0
#include "model_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::tools {
namespace {

void apply(YAML::Node& node, const std::string& override_text) {
  const auto equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw ConfigError("--set: '" + override_text + "' must be key=value");
  }
  try {
    node[override_text.substr(0, equals)] = YAML::Load(override_text.substr(equals + 1));
  } catch (const YAML::Exception&) {
    throw ConfigError("--set: '" + override_text + "' has a value that is not YAML");
  }
}

std::string law_text(const std::string& which, const decision::Density& law) {
  std::ostringstream text;
  text << std::setprecision(10);
  if (law.family() == decision::Family::normal) {
    text << which << "_mean: " << law.parameters()[0] << '\n';
    text << which << "_sd: " << law.parameters()[1] << '\n';
    return text.str();
  }
  text << which << "_family: " << to_string(law.family()) << '\n' << which << "_parameters: [";
  const auto names = parameter_names(law.family());
  for (std::size_t i = 0; i < names.size(); ++i) {
    text << (i > 0 ? ", " : "") << law.parameters()[i];
  }
  text << "]  #";
  for (const char* name : names) text << ' ' << name;
  text << '\n';
  return text.str();
}

}  // namespace

decision::PolicyParams load_model(const std::string& path,
                                  const std::vector<std::string>& overrides) {
  YAML::Node node = path.empty() ? YAML::Node(YAML::NodeType::Map) : read_yaml_file(path);
  for (const std::string& one : overrides) apply(node, one);
  return load_parameters<decision::PolicyParams>(node, "policy", path.empty() ? "--set" : path);
}

std::string model_text(const decision::Density& good, const decision::Density& bad,
                       const std::string& origin) {
  return "# " + origin + "\n" + law_text("good", good) + law_text("bad", bad);
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) throw ConfigError(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace tocsin::tools
