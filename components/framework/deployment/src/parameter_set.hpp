// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "section.hpp"

namespace tocsin::deployment {

/// Parameters of all components, collected from several places; a later place wins key by key.
class ParameterSet {
 public:
  /// Adds a map of "name -> map" or "host/name -> map"; the process may stand in the name, too.
  /// `sources` must outlive the set.
  void add_file(const YAML::Node& root, const YamlSources& sources);
  /// Adds "name.key=value" or "host/name.key=value", value in YAML; no value is an empty text.
  /// Variables are replaced in it.
  void add_setting(const std::string& setting, const Variables& variables, YamlSources& sources);
  /// Puts what was added from files below, and the settings above, the instance's own parameters.
  /// `process` is "host/process".
  void apply(const std::string& process, ComponentInstance& instance) const;
  /// Throws ConfigError when something was added for a component that the deployment has not, and
  /// that is not one of `removed` either.
  void reject_unknown_components(const Deployment& deployment,
                                 const std::set<std::string>& removed) const;

 private:
  struct Entry {
    std::string component;  ///< as it was given: name, host/name, /host/process/name, ...
    YAML::Node key;
    YAML::Node value;
  };
  static void merge(const std::vector<Entry>& entries, const std::string& path,
                    YAML::Node& parameters);

  std::vector<Entry> from_files_;
  std::vector<Entry> settings_;
  std::map<std::string, std::string> component_places_;
};

}  // namespace tocsin::deployment
