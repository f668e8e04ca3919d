// SPDX-License-Identifier: Apache-2.0
#include "parameter_set.hpp"

#include <set>

#include "foundation/error.hpp"

namespace tocsin::deployment {
namespace {

/// Host and name of every component.
std::vector<std::pair<std::string, std::string>> instances_of(const Deployment& deployment) {
  std::vector<std::pair<std::string, std::string>> instances;
  for (const Host& host : deployment.hosts) {
    for (const Container& container : host.containers) {
      for (const ComponentInstance& instance : container.components) {
        instances.emplace_back(host.name, instance.name);
      }
    }
  }
  return instances;
}

/// Both nodes stay those that were read, which know their place.
void put(const YAML::Node& key, const YAML::Node& value, YAML::Node& map) {
  map.remove(key.Scalar());
  map.force_insert(key, value);
}

}  // namespace

void ParameterSet::add_file(const YAML::Node& root, const YamlSources& sources) {
  if (root.IsNull()) return;
  const Section names(root, "parameters", sources);
  for (const auto& entry : root) {
    const std::string component = entry.first.Scalar();
    component_places_[component] = sources.place(entry.first);
    if (entry.second.IsNull()) continue;
    const Section keys(entry.second, component, sources);
    for (const auto& parameter : entry.second) {
      from_files_.push_back({component, parameter.first, parameter.second});
    }
  }
}

void ParameterSet::add_setting(const std::string& setting, YamlSources& sources) {
  const std::size_t dot = setting.find('.');
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || equals < dot + 2) {
    throw ConfigError("--set " + setting + ": must be name.key=value or host/name.key=value");
  }
  const std::string component = setting.substr(0, dot);
  component_places_[component] = "--set " + setting;
  const std::string key = setting.substr(dot + 1, equals - dot - 1);
  const YAML::Node value = sources.parse(setting.substr(equals + 1), "--set " + setting);
  settings_.push_back({component, sources.parse("'" + key + "'", "--set " + setting), value});
}

void ParameterSet::merge(const std::vector<Entry>& entries, const std::string& component,
                         YAML::Node& parameters) {
  for (const Entry& entry : entries) {
    if (entry.component == component) put(entry.key, entry.value, parameters);
  }
}

void ParameterSet::apply(const std::string& host, ComponentInstance& instance) const {
  YAML::Node merged(YAML::NodeType::Map);
  const std::string here = host + "/" + instance.name;
  merge(from_files_, instance.name, merged);
  merge(from_files_, here, merged);
  for (const auto& own : *instance.parameters) put(own.first, own.second, merged);
  merge(settings_, instance.name, merged);
  merge(settings_, here, merged);
  instance.parameters = std::make_shared<const YAML::Node>(merged);
}

void ParameterSet::reject_unknown_components(const Deployment& deployment,
                                             const std::set<std::string>& removed) const {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& [host, name] : instances_of(deployment)) {
    if (known.insert(name).second) names.push_back(name);
    known.insert(host + "/" + name);
  }
  for (const auto& [component, place] : component_places_) {
    const bool is_setting = place.rfind("--set ", 0) == 0;
    const std::string name = component.substr(component.find('/') + 1);  // without the host
    if (known.count(component) != 0 || (!is_setting && removed.count(name) != 0)) continue;
    throw ConfigError(component + ": no such component in " + deployment.file + "; allowed: [" +
                      joined(names) + "] (" + place + ")");
  }
}

}  // namespace tocsin::deployment
