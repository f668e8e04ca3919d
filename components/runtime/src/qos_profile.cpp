// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_profile.hpp"

#include <limits>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

/// `topics` of the file; absent keys stay negative, which no range allows in a file.
struct OverrideParams : TopicOverride {
  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("max_rate_hz", max_rate_hz, {0.001, inf}, "[Hz] in place of the profile's");
    v("minimum_separation_s", minimum_separation_s, {0, 3600}, "[s] in place of the profile's");
  }
};

const YAML::Node& need_map(const YAML::Node& node, const std::string& owner,
                           const std::string& path) {
  if (!node.IsMap()) throw ConfigError(owner + ": must be a map" + yaml_place(path, node));
  return node;
}

/// The place of a key of `node`, or of `node` when it does not have the key.
std::string place_of(const std::string& path, const YAML::Node& node, const std::string& key) {
  const YAML::Node found = node.IsMap() ? node[key] : YAML::Node();
  return yaml_place(path, found.IsDefined() ? found : node);
}

void refuse_unsupported(const std::string& owner, const YAML::Node& node, const std::string& path) {
  if (!node.IsMap()) return;
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    const std::string why = refusal(key, entry.second.IsScalar() ? entry.second.Scalar() : "");
    if (!why.empty()) {
      throw ConfigError(owner + "." + key + ": not supported: " + why +
                        yaml_place(path, entry.first));
    }
  }
}

}  // namespace

QosProfiles::QosProfiles(const std::string& path) : path_(path) {
  const YAML::Node file = read_yaml_file(path);
  if (!file.IsMap()) throw ConfigError(path + ": must be a map of QoS profiles");
  if (file["flow_controllers"].IsDefined()) read_flow_controllers(file["flow_controllers"]);
  if (file["topics"].IsDefined()) read_overrides(file["topics"]);
  for (const auto& entry : file) {
    const std::string name = entry.first.Scalar();
    if (name != "flow_controllers" && name != "topics") read_profile(name, entry.second);
  }
}

void QosProfiles::read_profile(const std::string& name, const YAML::Node& node) {
  refuse_unsupported(name, node, path_);
  const auto profile = load_parameters<QosProfile>(node, name, path_);
  if (const auto broken = conflict(profile)) {
    throw ConfigError(name + "." + broken->policy + ": " + broken->reason +
                      place_of(path_, node, broken->policy));
  }
  const std::string& flow = profile.flow_controller;
  if (!flow.empty() && flow_controllers_.count(flow) == 0) {
    throw ConfigError(name + ".flow_controller: '" + flow + "' is not one of flow_controllers" +
                      place_of(path_, node, "flow_controller"));
  }
  profiles_[name] = profile;
}

void QosProfiles::read_flow_controllers(const YAML::Node& node) {
  for (const auto& entry : need_map(node, "flow_controllers", path_)) {
    const std::string name = entry.first.Scalar();
    flow_controllers_[name] =
        load_parameters<FlowController>(entry.second, "flow_controllers." + name, path_);
  }
}

void QosProfiles::read_overrides(const YAML::Node& node) {
  for (const auto& entry : need_map(node, "topics", path_)) {
    const std::string name = entry.first.Scalar();
    TopicOverride& own = overrides_[name];
    own = load_parameters<OverrideParams>(entry.second, "topics." + name, path_);
    own.place = yaml_place(path_, entry.first);
  }
}

QosProfile QosProfiles::of(const std::string& profile, const std::string& topic) const {
  const auto found = profiles_.find(profile);
  if (found == profiles_.end()) {
    std::string known;
    for (const auto& entry : profiles_) known += (known.empty() ? "" : ", ") + entry.first;
    throw ConfigError("topic " + topic + ": QoS profile '" + profile + "' is not in " + path_ +
                      "; it has: " + known);
  }
  QosProfile qos = found->second;
  const auto own = overrides_.find(topic);
  if (own == overrides_.end()) return qos;
  if (own->second.max_rate_hz >= 0) qos.max_rate_hz = own->second.max_rate_hz;
  const double separation_s = own->second.minimum_separation_s;
  if (separation_s >= 0) qos.minimum_separation_s = separation_s;
  if (const auto broken = conflict(qos)) {
    throw ConfigError("topics." + topic + "." + broken->policy + ": " + broken->reason +
                      ", with the profile " + profile + own->second.place);
  }
  return qos;
}

std::vector<std::string> QosProfiles::overridden_topics() const {
  std::vector<std::string> names;
  for (const auto& entry : overrides_) names.push_back(entry.first);
  return names;
}

}  // namespace tocsin
