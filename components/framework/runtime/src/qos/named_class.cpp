// SPDX-License-Identifier: Apache-2.0
#include "named_class.hpp"

#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

TrafficClass class_named(const YAML::Node& name, const std::string& role,
                         const YamlSources& sources) {
  if (const auto found = traffic_class_of(name.Scalar())) return *found;
  std::vector<std::string> words;
  for (const TrafficClass one : traffic_classes) words.emplace_back(to_string(one));
  throw ConfigError(role + "." + name.Scalar() + ": is no traffic class" +
                    did_you_mean(words, name.Scalar(), "they are") + yaml_place(sources, name));
}

void add_classes(const YAML::Node& classes, Role role, const YamlSources& sources,
                 std::vector<NamedClass>& all) {
  for (const auto& entry : classes) {
    const std::string word = entry.first.Scalar();
    if (word == stays_key || word == fetch_key) continue;
    const TrafficClass one = class_named(entry.first, to_string(role), sources);
    const std::string key = std::string(to_string(role)) + "." + to_string(one);
    all.push_back({role, one, load_parameters<ClassEntry>(entry.second, key, sources), key,
                   yaml_place(sources, entry.first)});
  }
}

}  // namespace

std::vector<NamedClass> all_classes(const YAML::Node& file, const YamlSources& sources) {
  std::vector<NamedClass> all;
  for (const Role role : roles) {
    const YAML::Node classes = file[to_string(role)];
    if (classes.IsDefined() && classes.IsMap()) add_classes(classes, role, sources, all);
  }
  return all;
}

}  // namespace tocsin
