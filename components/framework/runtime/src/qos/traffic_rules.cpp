// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/traffic_rules.hpp"

#include <vector>

#include "command_line/programs.hpp"
#include "deployment/traffic_file.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

/// One class of the file.
struct TrafficClass {
  std::string while_poor = "send";
  std::vector<std::string> topics;
  template <class Visitor>
  void visit(Visitor& v) {
    v("while_poor", while_poor, {"send", "latest", "drop"}, "what the gate does with new samples");
    v("topics", topics, "ROS names of the topics of this class");
  }
};

WhilePoor to_while_poor(const std::string& word) {
  if (word == "latest") return WhilePoor::latest;
  return word == "drop" ? WhilePoor::drop : WhilePoor::send;
}

}  // namespace

TrafficRules::TrafficRules(const std::string& path, const std::string& role)
    : path_(path), role_(role) {
  YamlSources sources;
  const YAML::Node file =
      deployment::read_traffic_file(path, share_folder(own_program()).string(), sources);
  const YAML::Node classes = file.IsMap() ? file[role] : YAML::Node();
  if (!classes.IsDefined() || !classes.IsMap()) {
    throw ConfigError(path + ": has no map for the role '" + role + "'");
  }
  for (const auto& entry : classes) {
    const std::string name = entry.first.Scalar();
    const auto loaded = load_parameters<TrafficClass>(entry.second, role + "." + name, sources);
    for (const std::string& topic : loaded.topics) {
      const bool added = rules_.insert({topic, {name, to_while_poor(loaded.while_poor)}}).second;
      if (!added) {
        throw ConfigError(role + "." + name + ".topics: " + topic + " is in two classes" +
                          yaml_place(sources, entry.first));
      }
    }
  }
}

const TrafficRule& TrafficRules::of(const std::string& topic) const {
  const auto found = rules_.find(topic);
  if (found != rules_.end()) return found->second;
  static const TrafficRule never_paused{"none", WhilePoor::send};
  if (path_.empty()) return never_paused;
  throw ConfigError("topic " + topic + ": crosses the link, but has no traffic class for role " +
                    role_ + " in " + path_);
}

}  // namespace tocsin
