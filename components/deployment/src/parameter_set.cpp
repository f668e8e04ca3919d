// SPDX-License-Identifier: Apache-2.0
#include "parameter_set.hpp"

#include <set>

#include "foundation/error.hpp"
#include "foundation/yaml_file.hpp"

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

}  // namespace

void ParameterSet::add_file(const Source& source) {
  const YAML::Node root = read_yaml_file(source.file());
  if (root.IsNull()) return;
  const Section names(root, "parameters", source);
  for (const auto& entry : root) {
    const std::string component = entry.first.Scalar();
    component_origins_[component] = source.place(entry.first);
    if (entry.second.IsNull()) continue;
    const Section keys(entry.second, component, source);
    for (const auto& parameter : entry.second) {
      from_files_.push_back({component, parameter.first.Scalar(), source.resolve(parameter.second),
                             source.place(parameter.first)});
    }
  }
}

void ParameterSet::add_setting(const std::string& setting) {
  const std::size_t dot = setting.find('.');
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || equals < dot + 2) {
    throw ConfigError("--set " + setting + ": must be name.key=value or host/name.key=value");
  }
  const std::string component = setting.substr(0, dot);
  component_origins_[component] = "--set " + setting;
  try {
    settings_.push_back({component, setting.substr(dot + 1, equals - dot - 1),
                         YAML::Load(setting.substr(equals + 1)), "--set"});
  } catch (const YAML::ParserException& error) {
    throw ConfigError("--set " + setting + ": the value is not valid YAML: " + error.msg);
  }
}

void ParameterSet::merge(const std::vector<Entry>& entries, const std::string& component,
                         YAML::Node& parameters, std::map<std::string, std::string>& origins) {
  for (const Entry& entry : entries) {
    if (entry.component != component) continue;
    parameters[entry.key] = entry.value;
    origins[entry.key] = entry.origin;
  }
}

void ParameterSet::apply(const std::string& host, ComponentInstance& instance) const {
  YAML::Node merged(YAML::NodeType::Map);
  std::map<std::string, std::string> origins;
  const std::string here = host + "/" + instance.name;
  merge(from_files_, instance.name, merged, origins);
  merge(from_files_, here, merged, origins);
  for (const auto& own : *instance.parameters) {
    merged[own.first.Scalar()] = own.second;
    origins[own.first.Scalar()] = instance.origins[own.first.Scalar()];
  }
  merge(settings_, instance.name, merged, origins);
  merge(settings_, here, merged, origins);
  instance.parameters = std::make_shared<const YAML::Node>(merged);
  instance.origins = std::move(origins);
}

void ParameterSet::reject_unknown_components(const Deployment& deployment) const {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& [host, name] : instances_of(deployment)) {
    if (known.insert(name).second) names.push_back(name);
    known.insert(host + "/" + name);
  }
  for (const auto& [component, origin] : component_origins_) {
    if (known.count(component) != 0) continue;
    throw ConfigError(component + ": no such component in " + deployment.file + "; allowed: [" +
                      joined(names) + "] (" + origin + ")");
  }
}

}  // namespace tocsin::deployment
