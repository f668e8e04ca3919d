// SPDX-License-Identifier: Apache-2.0
#include "parameter_set.hpp"

#include <algorithm>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::deployment {
namespace {

/// Names and "host/process/name" of every component.
struct Instances {
  std::vector<std::string> names;
  std::vector<std::string> paths;
};

Instances instances_of(const Deployment& deployment) {
  Instances instances;
  std::set<std::string> known;
  for (const Host& host : deployment.hosts) {
    for (const Container& container : host.containers) {
      for (const ComponentInstance& instance : container.components) {
        instances.paths.push_back(host.name + "/" + container.name + "/" + instance.name);
        if (known.insert(instance.name).second) instances.names.push_back(instance.name);
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

void ParameterSet::add_setting(const std::string& setting, const Variables& variables,
                               YamlSources& sources) {
  const std::size_t dot = setting.find('.');
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || equals < dot + 2) {
    throw ConfigError("--set " + setting + ": must be name.key=value or host/name.key=value");
  }
  const std::string component = setting.substr(0, dot);
  component_places_[component] = "--set " + setting;
  const std::string key = setting.substr(dot + 1, equals - dot - 1);
  const std::string written = setting.substr(equals + 1);
  const YAML::Node value = sources.parse(written.empty() ? "''" : written, "--set " + setting);
  expand(value, sources, variables, RelativePaths::as_written);
  settings_.push_back({component, sources.parse("'" + key + "'", "--set " + setting), value});
}

/// What names the component alone comes first, so that what names its host or process wins.
void ParameterSet::merge(const std::vector<Entry>& entries, const std::string& path,
                         YAML::Node& parameters) {
  for (const bool alone : {true, false}) {
    for (const Entry& entry : entries) {
      if ((words_of_path(entry.component).size() == 1) != alone) continue;
      if (means(entry.component, path)) put(entry.key, entry.value, parameters);
    }
  }
}

void ParameterSet::apply(const std::string& process, ComponentInstance& instance) const {
  YAML::Node merged(YAML::NodeType::Map);
  const std::string path = process + "/" + instance.name;
  merge(from_files_, path, merged);
  for (const auto& own : *instance.parameters) put(own.first, own.second, merged);
  merge(settings_, path, merged);
  instance.parameters = std::make_shared<const YAML::Node>(merged);
}

void ParameterSet::reject_unknown_components(const Deployment& deployment,
                                             const std::set<std::string>& removed) const {
  const Instances instances = instances_of(deployment);
  const auto is_known = [&instances](const std::string& given) {
    return std::any_of(instances.paths.begin(), instances.paths.end(),
                       [&given](const std::string& path) { return means(given, path); });
  };
  for (const auto& [component, place] : component_places_) {
    const bool is_setting = place.rfind("--set ", 0) == 0;
    const auto words = words_of_path(component);
    const bool was_removed = !words.empty() && removed.count(words.back()) != 0;
    if (is_known(component) || (!is_setting && was_removed)) continue;
    throw ConfigError(component + ": no such component in " + deployment.file + "; allowed: [" +
                      joined(instances.names) + "]" + suggestion(instances.names, component) +
                      " (" + place + ")");
  }
}

}  // namespace tocsin::deployment
