// SPDX-License-Identifier: Apache-2.0
#include "model_file.hpp"

#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "decision/policy_params.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::tools {
namespace {

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

std::string model_text(const decision::Density& good, const decision::Density& bad,
                       const std::string& origin) {
  return "# " + printable(origin, 4096) + "\n" + law_text("good", good) + law_text("bad", bad);
}

void check_model(const std::string& text) {
  const std::string name = "the model";
  check(load_parameters<decision::PolicyParams>(read_yaml_text(text, name), "policy", name));
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) throw ConfigError(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace tocsin::tools
