// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_profile.hpp"

#include <limits>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_extends.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// An entry of `topics` of the file: what a topic has in place of its profile's.
struct OverrideParams {
  double max_rate_hz = inf;
  double minimum_separation_s = 0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("max_rate_hz", max_rate_hz, {0.001, inf}, "[Hz] in place of the profile's");
    v("minimum_separation_s", minimum_separation_s, {0, 3600}, "[s] in place of the profile's");
  }
};

/// `value`, as `node` has it under `key`; empty when it does not have the key.
std::optional<double> given(const YAML::Node& node, const char* key, double value) {
  return node[key].IsDefined() ? std::optional(value) : std::nullopt;
}

const YAML::Node& need_map(const YAML::Node& node, const std::string& owner,
                           const YamlSources& sources) {
  if (!node.IsMap()) throw ConfigError(owner + ": must be a map" + yaml_place(sources, node));
  return node;
}

/// The place of a key of `node`, or of `node` when it does not have the key.
std::string place_of(const YamlSources& sources, const YAML::Node& node, const std::string& key) {
  const YAML::Node found = node.IsMap() ? node[key] : YAML::Node();
  return yaml_place(sources, found.IsDefined() ? found : node);
}

void refuse_unsupported(const std::string& owner, const YAML::Node& node,
                        const YamlSources& sources) {
  if (!node.IsMap()) return;
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    const std::string why = refusal(key, entry.second.IsScalar() ? entry.second.Scalar() : "");
    if (!why.empty()) {
      throw ConfigError(owner + "." + key + ": not supported: " + why +
                        yaml_place(sources, entry.first));
    }
  }
}

}  // namespace

QosProfiles::QosProfiles() : path_("the built-in profiles") {
  QosProfile plain;
  plain.partition = {"", "*"};  // the partition without name, and all others
  const auto add = [&](const char* name, int depth, double heartbeat_s, double lifespan_s) {
    QosProfile& profile = profiles_[name] = plain;
    profile.depth = depth;
    profile.heartbeat_period_s = heartbeat_s;
    profile.lifespan_s = lifespan_s;
  };
  add("sensor", 5, plain.heartbeat_period_s, inf);
  add("command", 1, 0.2, 5);
  add("state", 1, 0.2, inf);
  add("event", 100, 0.1, inf);
  add("telemetry", 1, plain.heartbeat_period_s, inf);
  add("stream", 1, plain.heartbeat_period_s, 1);
  add("log", 1000, plain.heartbeat_period_s, 10);
  for (const char* name : {"sensor", "telemetry", "stream"}) {
    profiles_[name].requested_reliability = RequestedReliability::best_effort;
  }
  for (const char* name : {"state", "log"})
    profiles_[name].durability = Durability::transient_local;
}

QosProfiles::QosProfiles(const std::string& path) : path_(path) {
  const std::string shipped = (share_folder(own_program()) / "config").string();
  const YAML::Node file = read_extended(path, {shipped}, sources_);
  if (!file.IsMap()) throw ConfigError(path + ": must be a map of QoS profiles");
  if (file["topics"].IsDefined()) read_overrides(file["topics"]);
  for (const auto& entry : file) {
    const std::string name = entry.first.Scalar();
    if (name != "topics") read_profile(name, entry.second);
  }
}

void QosProfiles::read_profile(const std::string& name, const YAML::Node& node) {
  refuse_unsupported(name, node, sources_);
  const auto profile = load_parameters<QosProfile>(node, name, sources_);
  if (const auto broken = conflict(profile)) {
    throw ConfigError(name + "." + broken->policy + ": " + broken->reason +
                      place_of(sources_, node, broken->policy));
  }
  profiles_[name] = profile;
}

void QosProfiles::read_overrides(const YAML::Node& node) {
  const YAML::Node topics = need_map(node, "topics", sources_);
  for (const auto& entry : topics) {
    const std::string name = entry.first.Scalar();
    TopicOverride& own = overrides_[name];
    const auto read = load_parameters<OverrideParams>(entry.second, "topics." + name, sources_);
    own = {given(entry.second, "max_rate_hz", read.max_rate_hz),
           given(entry.second, "minimum_separation_s", read.minimum_separation_s),
           yaml_place(sources_, entry.first)};
  }
}

QosProfile QosProfiles::of(const std::string& profile, const std::string& topic) const {
  const auto found = profiles_.find(profile);
  if (found == profiles_.end()) {
    throw ConfigError(
        "topic " + topic + ": QoS profile '" + profile + "' is not in " + path_ +
        "; it has: " + joined_of(profiles_, [](const auto& known) { return known.first; }));
  }
  QosProfile qos = found->second;
  const auto own = overrides_.find(topic);
  if (own == overrides_.end()) return qos;
  qos.max_rate_hz = own->second.max_rate_hz.value_or(qos.max_rate_hz);
  qos.minimum_separation_s = own->second.minimum_separation_s.value_or(qos.minimum_separation_s);
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

void refuse_owners_on_link(const TopicInfo& topic, const QosContract& qos) {
  if (topic.scope != Scope::link || !qos.exclusive()) return;
  throw ConfigError(std::string("topic ") + topic.name +
                    ": crosses the link; ownership: exclusive is for host topics");
}

}  // namespace tocsin
