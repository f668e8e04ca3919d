// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/traffic_rules.hpp"

#include <algorithm>
#include <vector>

#include "command_line/programs.hpp"
#include "deployment/traffic_file.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

/// One class of a role.
struct ClassEntry {
  std::string while_poor = "send";
  std::vector<std::string> topics;
  std::vector<std::string> adaptive;
  std::vector<std::string> store;
  double min_rate_hz = 0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("while_poor", while_poor, {"send", "latest", "drop", "store"},
      "what the gate does with new samples");
    v("topics", topics, "ROS names of the topics of this class");
    v("adaptive", adaptive, "those of them whose writers follow the link's budget");
    v("store", store, "those of them of which nothing is lost: a log keeps what does not cross");
    v("min_rate_hz", min_rate_hz, {0, 1000},
      "[1/s] its topics may be thinned to this while the budget is short; 0: never");
  }
};

/// The file's map `dscp`.
struct DscpEntry {
  int critical = tocsin::dscp(TrafficClass::critical);
  int high = tocsin::dscp(TrafficClass::high);
  int normal = tocsin::dscp(TrafficClass::normal);
  int low = tocsin::dscp(TrafficClass::low);
  template <class Visitor>
  void visit(Visitor& v) {
    v("critical", critical, {0, 63}, "[1] DSCP of the packets of class critical");
    v("high", high, {0, 63}, "[1] DSCP of the packets of class high");
    v("normal", normal, {0, 63}, "[1] DSCP of the packets of class normal");
    v("low", low, {0, 63}, "[1] DSCP of the packets of class low");
  }
};

DscpOfClass to_dscp(const DscpEntry& entry) {
  DscpOfClass dscp;
  dscp.set(TrafficClass::critical, static_cast<std::uint8_t>(entry.critical));
  dscp.set(TrafficClass::high, static_cast<std::uint8_t>(entry.high));
  dscp.set(TrafficClass::normal, static_cast<std::uint8_t>(entry.normal));
  dscp.set(TrafficClass::low, static_cast<std::uint8_t>(entry.low));
  return dscp;
}

void refuse_unknown_maps(const YAML::Node& file, const YamlSources& sources) {
  std::vector<std::string> known{"dscp"};
  for (const Role role : roles) known.emplace_back(to_string(role));
  for (const auto& entry : file) {
    const std::string key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw ConfigError("traffic classes: '" + key + "' is neither a role nor dscp" +
                      did_you_mean(known, key, "allowed") + yaml_place(sources, entry.first));
  }
}

/// A topic that its class calls adaptive or stored, and no class of the role has, is misspelt.
void refuse_unknown_topics(const YAML::Node& classes, const std::string& role,
                           const std::map<std::string, TrafficRule>& rules,
                           const YamlSources& sources) {
  std::vector<std::string> known;
  for (const auto& rule : rules) known.push_back(rule.first);
  for (const auto& entry : classes) {
    for (const char* const list : {"adaptive", "store"}) {
      for (const YAML::Node& topic : entry.second[list]) {
        if (rules.count(topic.Scalar()) != 0) continue;
        throw ConfigError(role + "." + entry.first.Scalar() + "." + list + ": " + topic.Scalar() +
                          " is in no class of this role" +
                          did_you_mean(known, topic.Scalar(), "topics") +
                          yaml_place(sources, topic));
      }
    }
  }
}

bool names(const std::vector<std::string>& list, const std::string& topic) {
  return std::find(list.begin(), list.end(), topic) != list.end();
}

TrafficClass class_named(const YAML::Node& name, const std::string& role,
                         const YamlSources& sources) {
  if (const auto found = traffic_class_of(name.Scalar())) return *found;
  std::vector<std::string> words;
  for (const TrafficClass one : traffic_classes) words.emplace_back(to_string(one));
  throw ConfigError(role + "." + name.Scalar() + ": is no traffic class" +
                    did_you_mean(words, name.Scalar(), "they are") + yaml_place(sources, name));
}

/// Of what a log keeps, the newest still goes on resume as it is.
WhilePoor to_while_poor(const std::string& word) {
  if (word == "latest" || word == "store") return WhilePoor::latest;
  return word == "drop" ? WhilePoor::drop : WhilePoor::send;
}

}  // namespace

TrafficRules::TrafficRules(const std::string& path, Role of) : path_(path), role_(of) {
  const std::string role = to_string(of);
  YamlSources sources;
  const YAML::Node file =
      deployment::read_traffic_file(path, share_folder(own_program()).string(), sources);
  const YAML::Node classes = file.IsMap() ? file[role] : YAML::Node();
  if (!classes.IsDefined() || !classes.IsMap()) {
    throw ConfigError(path + ": has no map for the role '" + role + "'");
  }
  refuse_unknown_maps(file, sources);
  dscp_ = to_dscp(load_parameters<DscpEntry>(file["dscp"], "dscp", sources));
  for (const auto& entry : classes) {
    const TrafficClass traffic_class = class_named(entry.first, role, sources);
    const std::string name = to_string(traffic_class);
    const auto loaded = load_parameters<ClassEntry>(entry.second, role + "." + name, sources);
    for (const std::string& topic : loaded.topics) {
      const TrafficRule rule{traffic_class, to_while_poor(loaded.while_poor),
                             names(loaded.adaptive, topic), loaded.min_rate_hz,
                             loaded.while_poor == "store" || names(loaded.store, topic)};
      if (!rules_.insert({topic, rule}).second) {
        throw ConfigError(role + "." + name + ".topics: " + topic + " is in two classes" +
                          yaml_place(sources, entry.first));
      }
    }
  }
  refuse_unknown_topics(classes, role, rules_, sources);
}

const TrafficRule& TrafficRules::of(const std::string& topic) const {
  const auto found = rules_.find(topic);
  if (found != rules_.end()) return found->second;
  static const TrafficRule never_paused;
  if (path_.empty()) return never_paused;
  throw ConfigError("topic " + topic + ": crosses the link, but has no traffic class for role " +
                    to_string(role_) + " in " + path_);
}

}  // namespace tocsin
