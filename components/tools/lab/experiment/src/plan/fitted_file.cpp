// SPDX-License-Identifier: Apache-2.0
#include "plan/fitted_file.hpp"

#include <yaml-cpp/yaml.h>

#include <sstream>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::experiment {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path, const YAML::Node& node) {
  throw ConfigError("fitted." + what + yaml_place(path, node));
}

std::vector<std::string> settings(const YAML::Node& list, const std::string& owner,
                                  const std::string& path) {
  if (!list.IsSequence()) fail(owner + ": is not a list of key=value", path, list);
  std::vector<std::string> result;
  for (const YAML::Node& entry : list) {
    const bool good = entry.IsScalar() && entry.Scalar().find('=') != std::string::npos;
    if (!good) fail(owner + ": has an entry that is not key=value", path, entry);
    result.push_back(entry.Scalar());
  }
  return result;
}

Fitted read(const YAML::Node& root, const std::string& path) {
  if (!root.IsMap()) fail("file: is not a map of missions", path, root);
  Fitted fitted;
  for (const auto& mission : root) {
    const std::string name = mission.first.Scalar();
    if (!mission.second.IsMap()) fail(name + ": is not a map of policies", path, mission.second);
    for (const auto& policy : mission.second) {
      const std::string& key = policy.first.Scalar();
      fitted[name][key] = settings(policy.second, name + "." + key, path);
    }
  }
  return fitted;
}

}  // namespace

std::string fitted_key(const std::string& mission, int fit) {
  return fit == 1 ? mission : mission + "/" + std::to_string(fit);
}

int fit_of(int index, int fits) { return (index - 1) % fits + 1; }

std::vector<std::string> settings_for(const Fitted& fitted, const std::string& mission,
                                      const std::string& policy) {
  const auto found = fitted.find(mission);
  if (found == fitted.end()) return {};
  std::vector<std::string> result;
  for (const std::string& name : {std::string(every_policy), policy}) {
    const auto entry = found->second.find(name);
    if (entry == found->second.end()) continue;
    result.insert(result.end(), entry->second.begin(), entry->second.end());
  }
  return result;
}

Fitted load_fitted(const std::string& path) { return read(read_yaml_file(path), path); }

Fitted parse_fitted(const std::string& text, const std::string& path) {
  return read(read_yaml_text(text, path), path);
}
std::string fitted_text(const Fitted& fitted, const std::string& comment) {
  std::string text = "# SPDX-License-Identifier: Apache-2.0\n";
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  for (const auto& [mission, policies] : fitted) {
    text += mission + ":\n";
    for (const auto& [policy, settings] : policies) {
      text += "  " + policy + ": [" + joined(settings) + "]\n";
    }
  }
  return text;
}

}  // namespace tocsin::experiment
