// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "section.hpp"

namespace tocsin::deployment {

/// Parameters of all components, collected from several places; a later place wins key by key.
class ParameterSet {
 public:
  /// Adds a file of "name -> map" or "host/name -> map".
  void add_file(const Source& source);
  /// Adds "name.key=value" or "host/name.key=value", value in YAML.
  void add_setting(const std::string& setting);
  /// Puts what was added from files below, and the settings above, the instance's own parameters.
  void apply(const std::string& host, ComponentInstance& instance) const;
  /// Throws ConfigError when something was added for a component that the deployment has not.
  void reject_unknown_components(const Deployment& deployment) const;

 private:
  struct Entry {
    std::string component;  ///< name or host/name
    std::string key;
    YAML::Node value;
    std::string origin;
  };
  static void merge(const std::vector<Entry>& entries, const std::string& component,
                    YAML::Node& parameters, std::map<std::string, std::string>& origins);

  std::vector<Entry> from_files_;
  std::vector<Entry> settings_;
  std::map<std::string, std::string> component_origins_;
};

}  // namespace tocsin::deployment
