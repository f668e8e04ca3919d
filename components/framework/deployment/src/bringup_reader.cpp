// SPDX-License-Identifier: Apache-2.0
#include "bringup_reader.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/yaml_file.hpp"
#include "parts.hpp"
#include "reader.hpp"

namespace tocsin::deployment {
namespace {

constexpr int max_domain = 229;  // three ids follow each other; RTPS ports end at domain 232
constexpr int seed_step = 1000;  // from one vehicle to the next

/// `parameters` come after the base's; what has a name is known by it.
ListMerge bringup_lists(const YamlPath& path) {
  if (path == YamlPath{"parameters"}) return ListMerge::append;
  const bool of_a_host =
      path.size() == 3 && path[0] == "hosts" && (path[2] == "programs" || path[2] == "containers");
  const bool of_a_container =
      path.size() == 5 && path[0] == "hosts" && path[2] == "containers" && path[4] == "components";
  return of_a_host || of_a_container ? ListMerge::by_name : ListMerge::replace;
}

/// Every text in what was taken away, the names of its components among them.
void add_texts(const YAML::Node& removed, std::set<std::string>& texts) {
  if (removed.IsScalar()) texts.insert(removed.Scalar());
  for (const auto& entry : removed) add_texts(removed.IsMap() ? entry.second : entry, texts);
}

/// What network_monitor probes where no file and no `--set` says it: the first peer of its host, or
/// the one that its host speaks with.
void set_target(const Host& host, ComponentInstance& instance) {
  if (instance.component != "network_monitor" || (*instance.parameters)["target"]) return;
  if (host.peers.empty()) {
    throw ConfigError("hosts." + host.name + ": " + instance.name +
                      " has no target, and the host has no peer to probe (" + instance.place + ")");
  }
  YAML::Node parameters = *instance.parameters;
  parameters["target"] = host.peers.front();
  if (host.sites.size() < 2 || parameters["sites"]) return;
  parameters["sites"] = host.sites;
  parameters["site_targets"] = host.peers;
}

bool is_one_of_several_sites(const Deployment& deployment, const std::string& host) {
  return std::any_of(deployment.hosts.begin(), deployment.hosts.end(), [&](const Host& one) {
    const auto& sites = one.sites;
    return sites.size() > 1 && std::find(sites.begin(), sites.end(), host) != sites.end();
  });
}

/// A station that is not the only one does not take up what another one has pressed.
void set_only_station(const Deployment& deployment, const Host& host, ComponentInstance& instance) {
  if (instance.component != "emergency_stop" || (*instance.parameters)["only_station"]) return;
  if (!is_one_of_several_sites(deployment, host.name)) return;
  YAML::Node parameters = *instance.parameters;
  parameters["only_station"] = false;
}

/// Before the first airtime_share tells it, a router knows from the file who shares the air. A
/// relay has its site on wire.
void set_vehicles(std::size_t vehicles, ComponentInstance& instance) {
  constexpr std::size_t most = 100;  // that a router counts
  if (vehicles < 2 || instance.component != "link_router" || (*instance.parameters)["vehicles"])
    return;
  YAML::Node parameters = *instance.parameters;
  parameters["vehicles"] = std::min(vehicles, most);
}

/// A file of parameters is for all: a variable that only vehicles have stays in it as it is.
void reject_variables(const YAML::Node& node, const std::string& owner,
                      const YamlSources& sources) {
  if (node.IsScalar() && node.Scalar().find("${") != std::string::npos) {
    throw ConfigError(owner + ": '" + node.Scalar() + "' is known where `vehicles` is, and this " +
                      "component is none of a vehicle's" + yaml_place(sources, node));
  }
  for (const auto& entry : node) {
    reject_variables(node.IsMap() ? entry.second : entry, owner, sources);
  }
}

/// The two hosts of a relay, by their roles.
Relay relay_of(const Deployment& deployment, bool has_vehicles) {
  Relay relay;
  for (const Host& host : deployment.hosts) {
    (host.role == Role::uxv ? relay.site : relay.station) = host.name;
  }
  const bool has_both = !relay.site.empty() && !relay.station.empty();
  if (has_both && deployment.hosts.size() == 2 && has_vehicles && !deployment.radio) return relay;
  throw ConfigError(
      "relay: needs `vehicles`, a host with role uxv, which is the site, and one with role gcs; no "
      "`radio` (" +
      deployment.file + ")");
}

Variables known_to_all(const std::string& run_dir, int seed, const std::string& share) {
  return {{"run_dir", run_dir}, {"seed", std::to_string(seed)}, {"share", share}};
}

}  // namespace

void BringupReader::read() {
  const YAML::Node root = read_root(&removed_);
  const Section section(root, "deployment", sources(),
                        body_keys({"domain", "parameters", "variables"}));
  is_relay_ = section.flag("relay", false);
  vehicles_ = read_vehicles(root, is_relay_, sources());
  if (!vehicles_.empty()) keep_common(root, is_relay_, sources());
  variables_ = known_to_all(overrides_.run_dir, overrides_.seed, overrides_.share);
  expand(section.find("variables"), sources(), variables_);
  variables_.merge(read_variables(section, sources()));
  expand(root, sources(), variables_);
  read_body(section, sources(), Named::must_be_readable, deployment_);
  if (is_relay_) deployment_.relay = relay_of(deployment_, !vehicles_.empty());
  domain_ = section.whole("domain", 0, 0, max_domain);
  parameters_.common = read_parameters(section, common_of_files());
  for (const VehicleEntry& vehicle : vehicles_) add(vehicle);
  set_peers();
  name_sites();
  name_the_last();
}

YAML::Node BringupReader::read_root(std::vector<YamlRemoval>* removed) {
  return read_extended(path_, {overrides_.share + "/bringup", bringup_lists}, sources(), removed);
}

ParameterSet BringupReader::read_parameters(const Section& section, const Variables& variables) {
  const ExtendRules rules{overrides_.share + "/config"};
  ParameterSet parameters;
  const std::vector<std::string> files = section.texts("parameters");
  const std::vector<YAML::Node> nodes = section.items("parameters");
  for (std::size_t i = 0; i < files.size(); ++i) {
    const YAML::Node root = read_extended(sources().path(nodes[i], files[i]), rules, sources());
    expand(root, sources(), variables);
    parameters.add_file(root, sources());
  }
  for (const std::string& setting : overrides_.set)
    parameters.add_setting(setting, variables, sources());
  return parameters;
}

/// In a file of parameters, what only vehicles have means itself.
Variables BringupReader::common_of_files() const {
  Variables variables = variables_;
  for (const VehicleEntry& vehicle : vehicles_) {
    variables.emplace("vehicle", "${vehicle}");
    for (const auto& one : vehicle.variables) {
      variables.emplace(one, "${" + one + "}");
    }
  }
  return variables;
}

/// What a vehicle says itself goes before what the file says for all.
Variables BringupReader::variables_of(const VehicleEntry& vehicle, const YAML::Node& root) {
  const int before = static_cast<int>(deployment_.vehicles.size());
  Variables variables = known_to_all(overrides_.run_dir + "/" + vehicle.name,
                                     overrides_.seed + before * seed_step, overrides_.share);
  variables["vehicle"] = vehicle.name;
  const YAML::Node entry = root["vehicles"][vehicle.name];
  if (entry.IsMap()) {
    const Section section(entry, "vehicles." + vehicle.name, sources());
    expand(entry, sources(), variables);
    variables.merge(read_variables(section, sources()));
  }
  variables.insert(variables_.begin(), variables_.end());
  return variables;
}

void BringupReader::add(const VehicleEntry& vehicle) {
  const YAML::Node root = read_root(nullptr);
  const std::string like = vehicle_host(root, sources());
  keep_own(root, is_relay_, sources());
  const Variables variables = variables_of(vehicle, root);
  YAML::Node hosts = root["hosts"];
  if (!is_relay_) hosts[like]["address"] = vehicle.address;
  expand(hosts, sources(), variables);
  const Section section(root, "deployment", sources());
  parameters_.by_vehicle[vehicle.name] = read_parameters(section, variables);
  for (Host& host : read_hosts(hosts, sources())) {
    host.name == like && !is_relay_ ? add_vehicle(std::move(host), vehicle.name)
                                    : add_station(std::move(host), vehicle.name);
  }
  deployment_.vehicles.push_back(vehicle.name);
}

/// Vehicles come before the station.
void BringupReader::add_vehicle(Host host, const std::string& name) {
  if (host.enclave == host.name) host.enclave = name;
  for (const Program& one : host.programs) {
    copies_[host.name + "/" + one.name].push_back(name + "/" + one.name);
  }
  for (const Container& one : host.containers) {
    copies_[host.name + "/" + one.name].push_back(name + "/" + one.name);
  }
  host.name = name;
  const auto before = static_cast<std::ptrdiff_t>(deployment_.vehicles.size());
  deployment_.hosts.insert(deployment_.hosts.begin() + before, std::move(host));
}

/// What serves a vehicle comes after what serves all.
void BringupReader::add_station(Host host, const std::string& vehicle) {
  const auto known = std::find_if(deployment_.hosts.begin(), deployment_.hosts.end(),
                                  [&](const Host& one) { return one.name == host.name; });
  for (Container& container : host.containers) {
    const std::string name = vehicle + "_" + container.name;
    copies_[host.name + "/" + container.name].push_back(host.name + "/" + name);
    container.name = name;
    container.vehicle = vehicle;
    known->containers.push_back(std::move(container));
  }
}

/// The peers of the station are all vehicles.
void BringupReader::set_peers() {
  if (vehicles_.empty() || is_relay_) return;
  std::vector<std::string> addresses;
  for (const VehicleEntry& vehicle : vehicles_) addresses.push_back(vehicle.address);
  for (Host& host : deployment_.hosts) {
    if (!is_vehicle(deployment_, host.name)) host.peers = addresses;
  }
}

/// A vehicle with several peers knows them by the names of the hosts that have these addresses.
void BringupReader::name_sites() {
  for (Host& host : deployment_.hosts) {
    if (host.role != Role::uxv || is_relay_ || host.peers.size() < 2 || !host.sites.empty())
      continue;
    for (const std::string& peer : host.peers) {
      const auto site = std::find_if(deployment_.hosts.begin(), deployment_.hosts.end(),
                                     [&](const Host& one) { return one.address == peer; });
      if (site == deployment_.hosts.end()) {
        throw ConfigError("hosts." + host.name + ".peers: no host has address " + peer +
                          "; give the names of all peers as `sites`, the preferred one first (" +
                          deployment_.file + ")");
      }
      host.sites.push_back(site->name);
    }
  }
}

/// A process that there is for each vehicle stands for all of them.
void BringupReader::name_the_last() {
  std::vector<std::string> last;
  for (const std::string& given : deployment_.stop_when_exits) {
    const std::string name = without_slash(given);
    const auto known = copies_.find(name);
    const auto& all = known == copies_.end() ? std::vector<std::string>{name} : known->second;
    last.insert(last.end(), all.begin(), all.end());
  }
  deployment_.stop_when_exits = last;
}

/// A parameter file of the base may go on to set parameters of components that were taken away.
void BringupReader::merge() {
  std::set<std::string> removed;
  for (const YamlRemoval& removal : removed_) add_texts(*removal.value, removed);
  parameters_.common.reject_unknown_components(deployment_, removed);
  for (Host& host : deployment_.hosts) {
    for (Container& container : host.containers) merge(host, container);
  }
}

void BringupReader::merge(Host& host, Container& container) const {
  const std::string vehicle = vehicle_of(deployment_, host, container);
  const auto& own = vehicle.empty() ? parameters_.common : parameters_.by_vehicle.at(vehicle);
  const std::string process = host.name + "/" + container.name;
  Host facing = host;
  if (!container.vehicle.empty() && !is_relay_)
    facing.peers = {find_host(deployment_, vehicle)->address};
  for (ComponentInstance& instance : container.components) {
    own.apply(process, instance);
    if (vehicle.empty() && !vehicles_.empty()) {
      reject_variables(*instance.parameters, process + "/" + instance.name, deployment_.sources);
    }
    set_target(facing, instance);
    set_only_station(deployment_, host, instance);
    if (!is_relay_) set_vehicles(vehicles_.size(), instance);
  }
}

}  // namespace tocsin::deployment
