// SPDX-License-Identifier: Apache-2.0
#include "deployment/deployment.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

#include "bringup_reader.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "parts.hpp"
#include "reader.hpp"
#include "replacements.hpp"

namespace tocsin::deployment {
namespace {

bool has_one_of(const Host& host, const std::set<std::string>& components) {
  return std::any_of(host.containers.begin(), host.containers.end(), [&](const Container& one) {
    return std::any_of(
        one.components.begin(), one.components.end(),
        [&](const ComponentInstance& part) { return components.count(part.component) != 0; });
  });
}

[[noreturn]] void fail(const Deployment& deployment, const std::string& what) {
  throw ConfigError(what + " (" + deployment.file + ")");
}

void check_unique(const Deployment& deployment, const std::vector<std::string>& names,
                  const std::string& what) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) fail(deployment, name + ": " + what + " of this name twice");
  }
}

/// "host/name" of every component; of what serves one of several vehicles "host/vehicle/name".
std::vector<std::string> component_names(const Host& host) {
  std::vector<std::string> names;
  for (const Container& container : host.containers) {
    const std::string& vehicle = container.vehicle;
    const std::string place = host.name + "/" + (vehicle.empty() ? "" : vehicle + "/");
    for (const auto& instance : container.components) names.push_back(place + instance.name);
  }
  return names;
}

void check_components(const Deployment& deployment) {
  std::ptrdiff_t terminals = 0;
  for (const Host& host : deployment.hosts) {
    terminals += std::count_if(host.containers.begin(), host.containers.end(),
                               [](const Container& one) { return one.terminal; });
    check_unique(deployment, component_names(host), "component");
    if (!host.containers.empty() && (deployment.qos.empty() || deployment.traffic.empty())) {
      fail(deployment, "qos, traffic: both are needed when there are containers");
    }
  }
  if (terminals > 1) fail(deployment, "terminal: true in more than one container");
}

std::string network_of(const std::string& address) { return address.substr(0, address.rfind('.')); }

/// Of two hosts that name each other as peers both have a second path, or neither.
void check_second_paths(const Deployment& deployment) {
  for (const Host& host : deployment.hosts) {
    for (std::size_t i = 0; host.second && i < host.peers.size(); ++i) {
      const auto peer = std::find_if(deployment.hosts.begin(), deployment.hosts.end(),
                                     [&](const Host& one) { return one.address == host.peers[i]; });
      const std::string& by_second = host.second->peers[i];
      if (peer == deployment.hosts.end()) continue;
      if (peer->second && peer->second->address == by_second) continue;
      fail(deployment, "hosts." + host.name + ".second.peers: '" + by_second +
                           "' is not the second address of host " + peer->name + ", which " +
                           (peer->second ? "is " + peer->second->address : "has none"));
    }
  }
}

void check_second_radio(const Deployment& deployment) {
  if (deployment.radio->second.empty()) return;
  for (const Host& host : deployment.hosts) {
    if (!host.second) {
      fail(deployment, "radio.second: host " + host.name + " has no `second` with its address");
    }
    if (network_of(host.second->address) == network_of(host.address)) {
      fail(deployment, "hosts." + host.name + ".second.address: '" + host.second->address +
                           "' must be in another /24 network than " + host.address);
    }
  }
}

void check_addresses(const Deployment& deployment) {
  const auto& hosts = deployment.hosts;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (hosts[i].address != hosts[j].address &&
          network_of(hosts[i].address) == network_of(hosts[j].address)) {
        continue;
      }
      fail(deployment, "radio: the hosts' addresses " + hosts[j].address + " and " +
                           hosts[i].address + " must be different addresses of one /24 network");
    }
  }
}

std::size_t count_stations(const Deployment& deployment) {
  const auto is_station = [](const Host& host) { return host.role == Role::gcs; };
  const auto& hosts = deployment.hosts;
  return static_cast<std::size_t>(std::count_if(hosts.begin(), hosts.end(), is_station));
}

/// Hosts that a vehicle may speak with in place of another.
std::size_t count_sites(const Deployment& deployment) {
  std::set<std::string> sites;
  for (const Host& host : deployment.hosts) {
    for (const std::string& site : host.sites) {
      if (find_host(deployment, site) != nullptr) sites.insert(site);
    }
  }
  return sites.size();
}

/// Names and addresses of a vehicle's sites are those of hosts of the file, where it has them.
void check_sites(const Deployment& deployment) {
  for (const Host& host : deployment.hosts) {
    check_unique(deployment, host.sites, "site");
    for (std::size_t i = 0; i < host.sites.size(); ++i) {
      const Host* const site = find_host(deployment, host.sites[i]);
      const bool is_it =
          site == nullptr || (site->role == Role::gcs && site->address == host.peers[i]);
      if (is_it && host.role == Role::uxv) continue;
      fail(deployment, "hosts." + host.name + ".sites: '" + host.sites[i] +
                           "' is not a host of role gcs with address " + host.peers[i] +
                           ", or this host is no vehicle");
    }
  }
}

void check_radio(const Deployment& deployment) {
  check_second_paths(deployment);
  if (!deployment.radio) return;
  const std::size_t stations = count_stations(deployment);
  if (stations == 0 || stations == deployment.hosts.size()) {
    fail(deployment, "radio: needs two hosts, one with role uxv and one with role gcs");
  }
  check_addresses(deployment);
  if (deployment.vehicles.size() > 1 && !deployment.radio->second.empty()) {
    fail(deployment, "radio.second: is for one vehicle; there are " +
                         std::to_string(deployment.vehicles.size()));
  }
  check_second_radio(deployment);
}

/// A container that serves one of several serves one that there is, at the station.
void check_vehicle(const Deployment& deployment, const Host& host, const Container& container) {
  const std::string& vehicle = container.vehicle;
  const std::string owner = host.name + "/" + container.name + ": vehicle: '" + vehicle;
  if (!is_vehicle(deployment, vehicle)) {
    fail(deployment, owner + "' is not one of: [" + joined(deployment.vehicles) + "]");
  }
  if (is_vehicle(deployment, host.name)) {
    fail(deployment, owner + "' is for a container of the station");
  }
}

void check_vehicles(const Deployment& deployment) {
  if (deployment.vehicles.empty()) return;
  for (const Host& host : deployment.hosts) {
    if (host.second) {
      fail(deployment, "hosts." + host.name + ".second: is for a file without `vehicles`");
    }
    for (const Container& container : host.containers) {
      if (!container.vehicle.empty()) check_vehicle(deployment, host, container);
    }
  }
}

/// "host/process/component" of every component.
std::vector<std::string> component_paths(const Deployment& deployment) {
  std::vector<std::string> paths;
  for (const Host& host : deployment.hosts) {
    for (const Container& container : host.containers) {
      for (const ComponentInstance& instance : container.components) {
        paths.push_back(host.name + "/" + container.name + "/" + instance.name);
      }
    }
  }
  return paths;
}

template <class Item>
void erase_named(const std::string& name, std::vector<Item>& items) {
  const auto is_it = [&name](const Item& item) { return item.name == name; };
  items.erase(std::remove_if(items.begin(), items.end(), is_it), items.end());
}

/// Leaves out "host/process" or "host/process/component".
void erase_path(const std::string& path, Deployment& deployment) {
  const auto words = words_of_path(path);
  for (Host& host : deployment.hosts) {
    if (host.name != words[0]) continue;
    if (words.size() == 2) {
      erase_named(words[1], host.programs);
      erase_named(words[1], host.containers);
    }
    for (Container& container : host.containers) {
      if (words.size() == 3 && container.name == words[1])
        erase_named(words[2], container.components);
    }
  }
}

/// "gcs/mission" for "gcs/uxv1_mission", which there is for each of several vehicles.
std::string without_vehicle(const std::string& path, const Deployment& deployment) {
  auto words = words_of_path(path);
  for (const std::string& vehicle : deployment.vehicles) {
    if (words[1].rfind(vehicle + "_", 0) == 0) words[1].erase(0, vehicle.size() + 1);
  }
  return joined(words, "/");
}

/// The one of `paths` that is meant; of several vehicles all that are.
std::vector<std::string> resolved_paths(const std::string& given,
                                        const std::vector<std::string>& paths, const char* what,
                                        const Deployment& deployment) {
  std::vector<std::string> found;
  for (const std::string& path : paths) {
    if (deployment.vehicles.empty() || words_of_path(given) == words_of_path(path)) continue;
    const bool is_meant = means(given, path) || means(given, without_vehicle(path, deployment));
    if (is_meant) found.push_back(path);
  }
  if (found.empty()) found.push_back(resolve_path(given, paths, what));
  return found;
}

void leave_out(const std::string& given, Deployment& deployment) {
  const auto processes = process_names(deployment);
  const auto components = component_paths(deployment);
  const auto is_meant = [&](const std::string& path) {
    return means(given, path) || means(given, without_vehicle(path, deployment));
  };
  const bool is_component = std::none_of(processes.begin(), processes.end(), is_meant) &&
                            std::any_of(components.begin(), components.end(), is_meant);
  try {
    const auto paths = is_component ? resolved_paths(given, components, "component", deployment)
                                    : resolved_paths(given, processes, "process", deployment);
    auto& last = deployment.stop_when_exits;
    for (const std::string& path : paths) {
      last.erase(std::remove(last.begin(), last.end(), path), last.end());
      erase_path(path, deployment);
    }
  } catch (const ConfigError& error) {
    fail(deployment, std::string("--without ") + error.what());
  }
}

/// Throws when a component is none of those that can be loaded.
void check_installed(const Deployment& deployment, const std::vector<std::string>& installed) {
  const auto check = [&](const ComponentInstance& one) {
    if (std::find(installed.begin(), installed.end(), one.component) != installed.end()) return;
    throw ConfigError("no component '" + one.component + "' is installed" +
                      did_you_mean(installed, one.component, "there are") + " (" + one.place + ")");
  };
  for (const Host& host : deployment.hosts) {
    for (const Container& container : host.containers) {
      std::for_each(container.components.begin(), container.components.end(), check);
    }
  }
}

constexpr int max_open_domain = 231;     // RTPS ports end at domain 232
constexpr int max_secured_domain = 230;  // of governance and permissions: Cyclone DDS reads no more

/// Its link stays that to the others.
void keep_host(const std::string& name, Deployment& deployment) {
  if (is_vehicle(deployment, name)) {
    deployment.link_domain = part_of(deployment, name).link_domain;
    deployment.vehicles = {name};
  }
  auto& hosts = deployment.hosts;
  hosts = {*find_host(deployment, name)};
  keep_own_ends(deployment);
}

/// With an emulated radio each host has a network of its own.
void check_local_domains(const Deployment& deployment) {
  std::map<int, std::string> users;
  for (const Host& host : deployment.hosts) {
    const auto [known, is_new] = users.emplace(host.local_domain, host.name);
    if (is_new || deployment.radio) continue;
    fail(deployment, "hosts." + host.name + ".domain: " + std::to_string(host.local_domain) +
                         " is that of " + known->second +
                         ", too: start them with --host, each on its computer");
  }
}

void check_domains(const Deployment& deployment) {
  const int links = std::max(1, static_cast<int>(deployment.vehicles.size()));
  const int last = deployment.link_domain + links - 1;
  const int most = deployment.security.empty() ? max_open_domain : max_secured_domain;
  if (last <= most) return;
  const int domain =
      deployment.link_domain - std::max(2, static_cast<int>(deployment.hosts.size()));
  fail(deployment, "domain: " + std::to_string(domain) + " is above " +
                       std::to_string(domain - (last - most)) + ", the last one of " +
                       (deployment.vehicles.empty() ? "" : "so many vehicles and ") +
                       (deployment.security.empty() ? "an open link" : "a secured link"));
}

}  // namespace

void assign_domains(int domain, Deployment& deployment) {
  deployment.link_domain = domain + std::max(2, static_cast<int>(deployment.hosts.size()));
  for (Host& host : deployment.hosts) {
    if (host.local_domain == no_domain) host.local_domain = domain;
    ++domain;
  }
}

void check_whole(const Deployment& deployment) {
  const std::size_t hosts = deployment.hosts.size();
  const std::size_t sites = std::max<std::size_t>(1, count_sites(deployment));
  const std::size_t most = std::max<std::size_t>(1, deployment.vehicles.size()) + sites;
  if (hosts == 0 || hosts > most) {
    fail(deployment, "hosts: " + std::to_string(hosts) + " hosts; allowed are one or two" +
                         (deployment.vehicles.empty() ? "" : ", or all vehicles and a station") +
                         "; of role gcs more where they are sites of a vehicle");
  }
  std::vector<std::string> host_names;
  for (const Host& host : deployment.hosts) host_names.push_back(host.name);
  check_unique(deployment, host_names, "host");
  check_vehicles(deployment);
  const auto names = process_names(deployment);
  check_unique(deployment, names, "process");
  check_components(deployment);
  check_sites(deployment);
  check_radio(deployment);
  for (const std::string& last : deployment.stop_when_exits) {
    if (std::find(names.begin(), names.end(), last) != names.end()) continue;
    fail(deployment, "stop_when_exits: '" + last + "' is not one of: [" + joined(names) + "]" +
                         suggestion(names, last));
  }
}

Deployment load_deployment(const std::string& path, const Overrides& overrides) {
  Deployment deployment;
  deployment.file = path;
  BringupReader reader(path, overrides, deployment);
  reader.read();
  if (!overrides.host.empty()) deployment.radio.reset();  // its link is a real one
  if (!overrides.installed.empty()) check_installed(deployment, overrides.installed);
  deployment.run_dir = overrides.run_dir;
  deployment.share = overrides.share;
  deployment.seed = overrides.seed;
  check_whole(deployment);
  replace_files(overrides, deployment);
  reader.merge();
  for (const std::string& process : overrides.without) leave_out(process, deployment);
  assign_domains(overrides.domain.value_or(reader.domain()), deployment);
  check_domains(deployment);
  if (!overrides.host.empty()) keep_host(host_named(deployment, overrides.host).name, deployment);
  check_local_domains(deployment);
  return deployment;
}

std::string enclave_of(const Deployment& deployment, const Host& host) {
  return deployment.security.empty() ? "" : deployment.security + "/enclaves/" + host.enclave;
}

const Host& host_named(const Deployment& deployment, const std::string& given) {
  const std::string name = without_slash(given);
  if (const Host* const found = find_host(deployment, name)) return *found;
  for (const Host& host : deployment.hosts) {
    if (role_of(name) == host.role) return host;
  }
  std::vector<std::string> names;
  for (const Host& host : deployment.hosts) names.push_back(host.name);
  throw ConfigError("--host " + printable(given) + ": no such host in " + deployment.file +
                    "; allowed: [" + joined(names) + "]" + suggestion(names, name));
}

const Host* find_host(const Deployment& deployment, const std::string& name) {
  for (const Host& host : deployment.hosts) {
    if (host.name == name) return &host;
  }
  return nullptr;
}

bool is_routed(const Host& host) { return has_one_of(host, {"link_router"}); }

bool drives_a_vehicle(const Deployment& deployment) {
  const std::set<std::string> chain{"kobuki_driver", "safety_controller", "velocity_mux",
                                    "velocity_smoother"};
  return deployment.relay.has_value() ||
         std::any_of(deployment.hosts.begin(), deployment.hosts.end(),
                     [&](const Host& host) { return has_one_of(host, chain); });
}

const Container* find_container(const Host& host, const std::string& name) {
  for (const Container& container : host.containers) {
    if (container.name == name) return &container;
  }
  return nullptr;
}

}  // namespace tocsin::deployment
