// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_profile.hpp"

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {

QosProfiles::QosProfiles(const std::string& path) : path_(path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap()) throw ConfigError(path + ": must be a map of QoS profiles");
  for (const auto& entry : file) {
    const std::string name = entry.first.Scalar();
    profiles_[name] = load_parameters<QosProfile>(entry.second, name, path);
  }
}

const QosProfile& QosProfiles::of(const std::string& profile, const std::string& topic) const {
  const auto found = profiles_.find(profile);
  if (found != profiles_.end()) return found->second;
  std::string known;
  for (const auto& entry : profiles_) known += (known.empty() ? "" : ", ") + entry.first;
  throw ConfigError("topic " + topic + ": QoS profile '" + profile + "' is not in " + path_ +
                    "; it has: " + known);
}

}  // namespace tocsin
