// SPDX-License-Identifier: Apache-2.0
#include "fetch_rules.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

constexpr double any_number = std::numeric_limits<double>::infinity();

/// A rule as it stands in the file.
struct FetchEntry {
  std::string when;
  std::string field;
  double above = 0;
  double below = any_number;
  std::vector<std::string> topics;
  double before_s = 10;
  double after_s = 10;
  double min_interval_s = 5;
  template <class Visitor>
  void visit(Visitor& v) {
    v("when", when, "topic whose samples are looked at");
    v("field", field, "a number or truth of its type, with dots; none: any sample");
    v("above", above, {-any_number, any_number}, "the field is above this");
    v("below", below, {-any_number, any_number}, "and below this");
    v("topics", topics, "logged topics of this role, or patterns, that cross");
    v("before_s", before_s, {0, 600}, "[s] of the log before that sample");
    v("after_s", after_s, {0, 600}, "[s] and after it");
    v("min_interval_s", min_interval_s, {0, 86400},
      "[s] what comes within this time of the last that fulfilled it is the same event");
  }
};

/// What is wrong with it; empty: nothing.
std::string fault_of(const FetchEntry& entry) {
  if (entry.when.empty()) return ".when: a topic is to be named here";
  if (entry.topics.empty()) return ".topics: topics that cross are to be named here";
  if (entry.above >= entry.below) return ".above: is not less than below";
  if (entry.before_s + entry.after_s > 0) return "";
  return ".after_s: 0, and before_s 0, too: nothing is between them";
}

FetchRule to_rule(FetchEntry entry, std::string name) {
  FetchRule rule;
  rule.when = std::move(entry.when);
  rule.field = std::move(entry.field);
  rule.above = entry.above;
  rule.below = entry.below;
  rule.topics = std::move(entry.topics);
  rule.before_s = entry.before_s;
  rule.after_s = entry.after_s;
  rule.min_interval_s = entry.min_interval_s;
  rule.name = std::move(name);
  return rule;
}

/// Names and patterns of what is logged.
std::vector<std::string> logged_names(const NameRules<TrafficRule>& rules) {
  std::vector<std::string> logged;
  for (const auto* const some : {&rules.names(), &rules.patterns()}) {
    for (const auto& [name, rule] : *some) {
      if (rule.logged) logged.push_back(name);
    }
  }
  return logged;
}

/// Whether a log may have it.
bool is_logged(const std::string& topic, const std::vector<std::string>& logged) {
  return is_pattern(topic) ||
         std::any_of(logged.begin(), logged.end(), [&topic](const std::string& one) {
           return one == topic || (is_pattern(one) && fits(one, topic));
         });
}

}  // namespace

std::vector<FetchRule> fetch_rules(const YAML::Node& list, const std::string& role,
                                   const NameRules<TrafficRule>& rules,
                                   const YamlSources& sources) {
  std::vector<FetchRule> fetches;
  if (!list.IsDefined()) return fetches;
  const std::vector<std::string> logged = logged_names(rules);
  const std::string key = role + ".fetch";
  if (!list.IsSequence()) {
    throw ConfigError(key + ": is no list of rules" + yaml_place(sources, list));
  }
  for (const YAML::Node& node : list) {
    const std::string name = key + "[" + std::to_string(fetches.size()) + "]";
    auto entry = load_parameters<FetchEntry>(node, name, sources);
    const std::string fault = fault_of(entry);
    if (!fault.empty()) throw ConfigError(name + fault + yaml_place(sources, node));
    for (const std::string& topic : entry.topics) {
      if (!logged.empty() && is_logged(topic, logged)) continue;
      throw ConfigError(name + ".topics: " + topic + " is in no list log of this role" +
                        did_you_mean(logged, topic, "these are") + yaml_place(sources, node));
    }
    fetches.push_back(to_rule(std::move(entry), name));
  }
  return fetches;
}

}  // namespace tocsin
