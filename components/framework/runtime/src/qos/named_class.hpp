// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "class_entry.hpp"
#include "foundation/error.hpp"
#include "foundation/yaml_sources.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {

/// What a role says beside its classes.
inline constexpr const char* stays_key = "stays";
inline constexpr const char* fetch_key = "fetch";

/// What a class of a role says, and where.
struct NamedClass {
  Role role;
  TrafficClass traffic_class;
  ClassEntry entry;
  std::string key;    ///< `uxv.high`
  std::string place;  ///< in the file, for messages

  [[nodiscard]] bool has_calls() const { return !entry.services.empty() || !entry.actions.empty(); }
  [[nodiscard]] CallClass calls() const { return {role, traffic_class, entry.call_deadline_s}; }
  template <class Rule>
  void add(NameRules<Rule>& rules, const char* list, const std::string& name,
           const Rule& rule) const {
    if (rules.add(name, rule)) return;
    throw ConfigError(key + "." + list + ": " + name + " is in two classes" + place);
  }
};

/// Of all roles that the file has. Throws ConfigError with the place.
[[nodiscard]] std::vector<NamedClass> all_classes(const YAML::Node& file,
                                                  const YamlSources& sources);

}  // namespace tocsin
