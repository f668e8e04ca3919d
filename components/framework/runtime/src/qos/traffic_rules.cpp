// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/traffic_rules.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "command_line/programs.hpp"
#include "deployment/traffic_file.hpp"
#include "dscp_entry.hpp"
#include "fetch_rules.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"
#include "named_class.hpp"
#include "paths_entry.hpp"
#include "qos/vehicle_chain.hpp"
#include "runtime/middleware/action_ports.hpp"

namespace tocsin {
namespace {

void refuse_unknown_maps(const YAML::Node& file, const YamlSources& sources) {
  std::vector<std::string> known{"dscp", "paths"};
  for (const Role role : roles) known.emplace_back(to_string(role));
  for (const auto& entry : file) {
    const std::string key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw ConfigError("traffic classes: '" + key + "' is neither a role nor dscp nor paths" +
                      did_you_mean(known, key, "allowed") + yaml_place(sources, entry.first));
  }
}

/// Whether a name is one of these, or a pattern that fits one.
bool fits_any(const std::string& name, const std::vector<std::string>& known) {
  return std::any_of(known.begin(), known.end(), [&](const std::string& one) {
    return one == name || (is_pattern(name) && fits(name, one));
  });
}

/// A topic that its class calls adaptive, on demand, compressed or stored, and no class of the role
/// has, is misspelt.
void refuse_unknown_topics(const YAML::Node& classes, const std::string& role,
                           const NameRules<TrafficRule>& rules, const YamlSources& sources) {
  std::vector<std::string> known;
  for (const auto& rule : rules.names()) known.push_back(rule.first);
  for (const auto& rule : rules.patterns()) known.push_back(rule.first);
  for (const auto& entry : classes) {
    if (!entry.second.IsMap()) continue;
    for (const char* const list : {"adaptive", "on_demand", "compress", "store"}) {
      for (const YAML::Node& topic : entry.second[list]) {
        if (fits_any(topic.Scalar(), known)) continue;
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

/// Of what a log keeps, the newest still goes on resume as it is.
WhilePoor to_while_poor(const std::string& word) {
  if (word == "latest" || word == "store") return WhilePoor::latest;
  return word == "drop" ? WhilePoor::drop : WhilePoor::send;
}

TrafficRule rule_of(const std::string& topic, TrafficClass traffic_class, const ClassEntry& entry) {
  TrafficRule rule;
  rule.traffic_class = traffic_class;
  rule.while_poor = to_while_poor(entry.while_poor);
  rule.adaptive = names(entry.adaptive, topic);
  rule.on_demand = names(entry.on_demand, topic);
  rule.compressed = std::any_of(entry.compress.begin(), entry.compress.end(),
                                [&](const auto& one) { return fits_any(one, {topic}); });
  rule.stored = entry.while_poor == "store" || names(entry.store, topic);
  rule.logged = names(entry.log, topic);
  rule.max_rate_hz = entry.max_rate_hz;
  rule.depth = entry.depth;
  if (entry.lifespan_s > 0) rule.lifespan_s = entry.lifespan_s;
  return rule;
}

/// The list `stays` of a role; none: it says nothing.
std::vector<std::string> names_in(const YAML::Node& list, const std::string& role,
                                  const YamlSources& sources) {
  if (!list.IsDefined()) return {};
  std::vector<std::string> listed;
  for (std::size_t i = 0; list.IsSequence() && i < list.size(); ++i) {
    if (list[i].IsScalar()) listed.push_back(list[i].Scalar());
  }
  if (list.IsSequence() && listed.size() == list.size()) return listed;
  throw ConfigError(role + "." + stays_key + ": is no list of names of topics" +
                    yaml_place(sources, list));
}

/// Of its topics, and of those of its actions.
void add_topics(const NamedClass& from, NameRules<TrafficRule>& rules) {
  for (const std::string& topic : from.entry.topics) {
    const TrafficRule rule = rule_of(topic, from.traffic_class, from.entry);
    if (rule.on_demand && rule.stored) {
      throw ConfigError(from.key + ".on_demand: " + topic +
                        " is stored, so that all of it crosses anyway" + from.place);
    }
    from.add(rules, "topics", topic, rule);
  }
  for (const std::string& action : from.entry.actions) {
    for (const char* const end : {"feedback", "status"}) {
      const std::string topic = action_end(action, end);
      from.add(rules, "actions", topic, rule_of(topic, from.traffic_class, from.entry));
    }
  }
}

/// What its list `log` names: topics of this class, or of none. One that a pattern fits goes on
/// crossing by that.
void add_logged(const NamedClass& from, SentTopics& sent) {
  for (const std::string& topic : from.entry.log) {
    const TrafficRule* const known = sent.find(topic);
    if (known != nullptr && known->stored) {
      throw ConfigError(from.key + ".log: " + topic +
                        " is stored, so that all of it crosses anyway" + from.place);
    }
    if (names(from.entry.topics, topic)) continue;  // its rule says so already
    TrafficRule rule;
    rule.traffic_class = from.traffic_class;
    if (known != nullptr) rule = *known;
    rule.logged = true;
    rule.live = known != nullptr;
    from.add(sent.rules, "log", topic, rule);
  }
}

/// What its list `keep` names: topics of this class, or patterns.
template <class Keeps>
void add_kept(const NamedClass& from, NameRules<Keeps>& kept) {
  for (const std::string& topic : from.entry.keep) {
    std::vector<std::string> known = from.entry.topics;
    known.insert(known.end(), from.entry.log.begin(), from.entry.log.end());
    if (!is_pattern(topic) && !names(known, topic)) {
      throw ConfigError(from.key + ".keep: " + topic +
                        " is neither in topics nor in log of its class" +
                        did_you_mean(known, topic, "they have") + from.place);
    }
    (void)kept.add(topic, {});
  }
}

/// Of its services, and of those of its actions.
void add_services(const NamedClass& from, NameRules<CallRule>& rules) {
  CallRule rule{from.calls()};
  for (const std::string& service : from.entry.services) {
    rule.on_demand = is_pattern(service);
    from.add(rules, "services", service, rule);
  }
  for (const std::string& action : from.entry.actions) {
    rule.on_demand = is_pattern(action);
    for (const char* const end : {"send_goal", "cancel_goal", "get_result"}) {
      from.add(rules, "actions", action_end(action, end), rule);
    }
  }
}

/// Of one role.
SentTopics sent_by(Role role, const YAML::Node& file, const std::vector<NamedClass>& classes,
                   const YamlSources& sources) {
  const std::string word = to_string(role);
  SentTopics sent;
  const YAML::Node own = file[word];
  if (!own.IsDefined() || !own.IsMap()) return sent;
  for (const std::string& name : names_in(own[stays_key], word, sources)) {
    (void)sent.stays.add(name, {});
  }
  for (const NamedClass& one : classes) {
    if (one.role == role) add_topics(one, sent.rules);
  }
  refuse_unknown_topics(own, word, sent.rules, sources);
  for (const NamedClass& one : classes) {
    if (one.role == role) add_logged(one, sent);
  }
  return sent;
}

/// Nothing that drives the vehicle crosses the link, whoever names it.
void refuse_chain(const NamedClass& from, const SentTopics& sent) {
  const auto refuse = [&](const std::string& name, const std::string& what, const char* help) {
    throw ConfigError(from.key + ".topics: " + name + what +
                      " moves or stops this deployment's vehicle, and never crosses the link" +
                      help + from.place);
  };
  for (const std::string& name : from.entry.topics) {
    if (is_of_chain(name)) {
      refuse(name, "", "; goal, teleop/cmd_vel and docking/command do, and its log may cross");
    }
    if (!is_pattern(name)) continue;
    for (const char* const topic : chain_topics) {
      if (!fits(name, topic) || sent.find(topic) == nullptr || !sent.find(topic)->live) continue;
      refuse(name, std::string(" takes ") + topic + ", which",
             "; `stays` lists what no pattern takes");
    }
  }
}
void refuse_chain(Role role, const std::vector<NamedClass>& classes, const SentTopics& sent) {
  for (const NamedClass& one : classes) {
    if (one.role == role) refuse_chain(one, sent);
  }
}

/// The map of a role. Throws ConfigError when the file has none.
YAML::Node map_of(const YAML::Node& file, Role role, const std::string& path) {
  YAML::Node own = file.IsMap() ? file[to_string(role)] : YAML::Node();
  if (!own.IsDefined() || !own.IsMap()) {
    throw ConfigError(path + ": has no map for the role '" + to_string(role) + "'");
  }
  return own;
}

}  // namespace

std::array<PathUse, traffic_classes.size()> default_paths() { return to_paths({}); }

bool is_pattern(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

bool fits(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

const TrafficRule* SentTopics::find(const std::string& topic) const {
  const auto named = rules.names().find(topic);
  if (named != rules.names().end()) return &named->second;
  return stays.find(topic) == nullptr ? rules.find(topic) : nullptr;
}

TrafficRules::TrafficRules(const std::string& path, Role of, VehicleChain chain)
    : path_(path), role_(of), chain_(chain) {
  YamlSources sources;
  const YAML::Node file =
      deployment::read_traffic_file(path, share_folder(own_program()).string(), sources);
  const YAML::Node own = map_of(file, of, path);
  refuse_unknown_maps(file, sources);
  paths_ = to_paths(load_parameters<PathsEntry>(file["paths"], "paths", sources));
  dscp_ = to_dscp(load_parameters<DscpEntry>(file["dscp"], "dscp", sources));
  NameRules<Keeps> kept_there;  // looked at, and kept by the others
  const std::vector<NamedClass> classes = all_classes(file, sources);
  for (const NamedClass& one : classes) {
    add_kept(one, one.role == of ? kept_there : kept_here_);
    add_services(one, one.role == of ? served_ : called_);
    if (one.has_calls()) call_classes_.push_back(one.calls());
  }
  for (const Role role : roles) {
    SentTopics sent = sent_by(role, file, classes, sources);
    if (chain == VehicleChain::ours) refuse_chain(role, classes, sent);
    if (role == of) {
      own_ = std::move(sent);
    } else {
      others_.push_back(std::move(sent));
    }
  }
  fetches_ = fetch_rules(own[fetch_key], to_string(of), own_.rules, sources);
}

const TrafficRule* TrafficRules::find(const std::string& topic) const {
  const TrafficRule* const found = own_.find(topic);
  const bool stays = found != nullptr && found->live && chain_ == VehicleChain::ours;
  return stays && is_of_chain(topic) ? nullptr : found;
}

bool TrafficRules::waits_for_demand(const std::string& topic) const {
  const TrafficRule* const rule = find(topic);
  if (rule == nullptr || !rule->on_demand || rule->logged) return false;
  return std::none_of(fetches_.begin(), fetches_.end(),
                      [&](const FetchRule& fetch) { return fetch.when == topic; });
}

bool TrafficRules::takes(const std::string& topic) const {
  if (chain_ == VehicleChain::ours && is_of_chain(topic)) return false;
  return path_.empty() || std::any_of(others_.begin(), others_.end(), [&](const SentTopics& sent) {
           const TrafficRule* const rule = sent.find(topic);
           return rule != nullptr && rule->live;
         });
}

bool TrafficRules::takes_on_demand(const std::string& topic) const {
  const auto is_sent = [&](bool on_demand) {
    return std::any_of(others_.begin(), others_.end(), [&](const SentTopics& sent) {
      const TrafficRule* const rule = sent.find(topic);
      return rule != nullptr && rule->live && rule->on_demand == on_demand;
    });
  };
  return is_sent(true) && !is_sent(false);
}

bool TrafficRules::takes_later(const std::string& topic) const {
  return path_.empty() || std::any_of(others_.begin(), others_.end(), [&](const SentTopics& sent) {
           const TrafficRule* const rule = sent.find(topic);
           return rule != nullptr && (rule->stored || rule->logged);
         });
}

const TrafficRule& TrafficRules::of(const std::string& topic) const {
  if (const TrafficRule* const found = find(topic)) return *found;
  static const TrafficRule never_paused;
  if (path_.empty()) return never_paused;
  throw ConfigError("topic " + topic + ": crosses the link, but has no traffic class for role " +
                    to_string(role_) + " in " + path_);
}

}  // namespace tocsin
