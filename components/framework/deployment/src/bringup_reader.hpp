// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "foundation/yaml_extends.hpp"
#include "parameter_set.hpp"
#include "section.hpp"
#include "vehicles.hpp"

namespace tocsin::deployment {

/// What the files say of parameters: for what is there once, and for each vehicle.
struct AllParameters {
  ParameterSet common;
  std::map<std::string, ParameterSet> by_vehicle = {};
};

/// Reads a bringup file, whose one vehicle may stand for each of several. All arguments must
/// outlive it.
class BringupReader {
 public:
  BringupReader(const std::string& path, const Overrides& overrides, Deployment& deployment)
      : path_(path), overrides_(overrides), deployment_(deployment) {}

  /// All but domains and parameters. Throws ConfigError.
  void read();
  [[nodiscard]] int domain() const { return domain_; }
  /// Gives every component its parameters. Throws ConfigError.
  void merge();

 private:
  [[nodiscard]] YamlSources& sources() { return deployment_.sources; }
  [[nodiscard]] YAML::Node read_root(std::vector<YamlRemoval>* removed);
  [[nodiscard]] ParameterSet read_parameters(const Section& section, const Variables& variables);
  [[nodiscard]] Variables common_of_files() const;
  [[nodiscard]] Variables variables_of(const VehicleEntry& vehicle, const YAML::Node& root);
  void add(const VehicleEntry& vehicle);
  void add_vehicle(Host host, const std::string& name);
  void add_station(Host host, const std::string& vehicle);
  void set_peers();
  void name_sites();
  void name_the_last();
  void merge(Host& host, Container& container) const;

  const std::string& path_;
  const Overrides& overrides_;
  Deployment& deployment_;
  std::vector<YamlRemoval> removed_;
  std::vector<VehicleEntry> vehicles_;
  bool is_relay_ = false;
  Variables variables_;  ///< of what is there once
  AllParameters parameters_;
  /// Processes of the station that are for each vehicle, by what the file calls them.
  std::map<std::string, std::vector<std::string>> copies_;
  int domain_ = 0;
};

}  // namespace tocsin::deployment
