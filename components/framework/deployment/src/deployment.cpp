// SPDX-License-Identifier: Apache-2.0
#include "deployment/deployment.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_extends.hpp"
#include "parameter_set.hpp"
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

/// "host/process" of every process, in starting order.
std::vector<std::string> process_names(const Deployment& deployment) {
  std::vector<std::string> names;
  for (const Host& host : deployment.hosts) {
    for (const Program& program : host.programs) names.push_back(host.name + "/" + program.name);
    for (const Container& container : host.containers) {
      names.push_back(host.name + "/" + container.name);
    }
  }
  return names;
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

void check_components(const Deployment& deployment) {
  int terminals = 0;
  for (const Host& host : deployment.hosts) {
    std::vector<std::string> names;
    for (const Container& container : host.containers) {
      terminals += container.terminal ? 1 : 0;
      for (const auto& instance : container.components) {
        names.push_back(host.name + "/" + instance.name);
      }
    }
    check_unique(deployment, names, "component");
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

void check_radio(const Deployment& deployment) {
  check_second_paths(deployment);
  if (!deployment.radio) return;
  const auto& hosts = deployment.hosts;
  if (hosts.size() != 2 || hosts[0].role == hosts[1].role) {
    fail(deployment, "radio: needs two hosts, one with role uxv and one with role gcs");
  }
  if (hosts[0].address == hosts[1].address ||
      network_of(hosts[0].address) != network_of(hosts[1].address)) {
    fail(deployment, "radio: the hosts' addresses " + hosts[0].address + " and " +
                         hosts[1].address + " must be different addresses of one /24 network");
  }
  check_second_radio(deployment);
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

void leave_out(const std::string& given, Deployment& deployment) {
  const auto processes = process_names(deployment);
  const auto components = component_paths(deployment);
  const auto is_meant = [&given](const std::string& path) { return means(given, path); };
  const bool is_component = std::none_of(processes.begin(), processes.end(), is_meant) &&
                            std::any_of(components.begin(), components.end(), is_meant);
  try {
    const std::string path = is_component ? resolve_path(given, components, "component")
                                          : resolve_path(given, processes, "process");
    if (deployment.stop_when_exits == path) deployment.stop_when_exits.clear();
    erase_path(path, deployment);
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

/// Every text in what was taken away, the names of its components among them.
void add_texts(const YAML::Node& removed, std::set<std::string>& texts) {
  if (removed.IsScalar()) texts.insert(removed.Scalar());
  for (const auto& entry : removed) add_texts(removed.IsMap() ? entry.second : entry, texts);
}

/// What network_monitor probes where no file and no `--set` says it: the first peer of its host.
void set_target(const Host& host, ComponentInstance& instance) {
  if (instance.component != "network_monitor" || (*instance.parameters)["target"]) return;
  if (host.peers.empty()) {
    throw ConfigError("hosts." + host.name + ": " + instance.name +
                      " has no target, and the host has no peer to probe (" + instance.place + ")");
  }
  YAML::Node parameters = *instance.parameters;
  parameters["target"] = host.peers.front();
}

/// A parameter file of the base may go on to set parameters of components that were taken away.
void merge_parameters(const ParameterSet& parameters, const std::vector<YamlRemoval>& removals,
                      Deployment& deployment) {
  std::set<std::string> removed;
  for (const YamlRemoval& removal : removals) add_texts(*removal.value, removed);
  parameters.reject_unknown_components(deployment, removed);
  for (Host& host : deployment.hosts) {
    for (Container& container : host.containers) {
      for (ComponentInstance& instance : container.components) {
        parameters.apply(host.name + "/" + container.name, instance);
        set_target(host, instance);
      }
    }
  }
}

/// `parameters` come after the base's; what has a name is known by it.
ListMerge bringup_lists(const YamlPath& path) {
  if (path == YamlPath{"parameters"}) return ListMerge::append;
  const bool of_a_host =
      path.size() == 3 && path[0] == "hosts" && (path[2] == "programs" || path[2] == "containers");
  const bool of_a_container =
      path.size() == 5 && path[0] == "hosts" && path[2] == "containers" && path[4] == "components";
  return of_a_host || of_a_container ? ListMerge::by_name : ListMerge::replace;
}

ParameterSet read_parameters(const Section& section, const Overrides& overrides,
                             const Variables& variables, YamlSources& sources) {
  const ExtendRules rules{overrides.share + "/config"};
  ParameterSet parameters;
  const std::vector<std::string> files = section.texts("parameters");
  const std::vector<YAML::Node> nodes = section.items("parameters");
  for (std::size_t i = 0; i < files.size(); ++i) {
    const YAML::Node root = read_extended(sources.path(nodes[i], files[i]), rules, sources);
    expand(root, sources, variables);
    parameters.add_file(root, sources);
  }
  for (const std::string& setting : overrides.set) parameters.add_setting(setting, sources);
  return parameters;
}

constexpr int max_domain = 229;  // three ids follow each other; RTPS ports end at domain 232
constexpr int max_secured_domain = 230;  // of governance and permissions: Cyclone DDS reads no more

void check_security(const Deployment& deployment) {
  if (deployment.security.empty() || deployment.link_domain <= max_secured_domain) return;
  fail(deployment, "domain: " + std::to_string(deployment.link_domain - 2) +
                       " is above 228, the last one of a secured link");
}

}  // namespace

void assign_domains(int domain, Deployment& deployment) {
  for (Host& host : deployment.hosts) host.local_domain = domain++;
  deployment.link_domain = domain + (deployment.hosts.size() == 1 ? 1 : 0);
}

void check_whole(const Deployment& deployment) {
  if (deployment.hosts.empty() || deployment.hosts.size() > 2) {
    fail(deployment,
         "hosts: " + std::to_string(deployment.hosts.size()) + " hosts; allowed are one or two");
  }
  const auto names = process_names(deployment);
  check_unique(deployment, names, "process");
  check_components(deployment);
  check_radio(deployment);
  const std::string& last = deployment.stop_when_exits;
  if (!last.empty() && std::find(names.begin(), names.end(), last) == names.end()) {
    fail(deployment, "stop_when_exits: '" + last + "' is not one of: [" + joined(names) + "]" +
                         suggestion(names, last));
  }
}

Deployment load_deployment(const std::string& path, const Overrides& overrides) {
  const Variables variables{{"run_dir", overrides.run_dir},
                            {"seed", std::to_string(overrides.seed)},
                            {"share", overrides.share}};
  Deployment deployment;
  YamlSources& sources = deployment.sources;
  std::vector<YamlRemoval> removed;
  const YAML::Node root =
      read_extended(path, {overrides.share + "/bringup", bringup_lists}, sources, &removed);
  expand(root, sources, variables);
  const Section section(root, "deployment", sources, body_keys({"domain", "parameters"}));
  deployment.file = path;
  read_body(section, sources, Named::must_be_readable, deployment);
  if (!overrides.installed.empty()) check_installed(deployment, overrides.installed);
  deployment.run_dir = overrides.run_dir;
  deployment.share = overrides.share;
  deployment.seed = overrides.seed;
  const int domain = section.whole("domain", 0, 0, max_domain);
  const ParameterSet parameters = read_parameters(section, overrides, variables, sources);
  deployment.stop_when_exits = without_slash(deployment.stop_when_exits);
  check_whole(deployment);
  replace_files(overrides, deployment);
  merge_parameters(parameters, removed, deployment);
  for (const std::string& process : overrides.without) leave_out(process, deployment);
  assign_domains(overrides.domain.value_or(domain), deployment);
  check_security(deployment);
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
  return std::any_of(deployment.hosts.begin(), deployment.hosts.end(),
                     [&](const Host& host) { return has_one_of(host, chain); });
}

const Container* find_container(const Host& host, const std::string& name) {
  for (const Container& container : host.containers) {
    if (container.name == name) return &container;
  }
  return nullptr;
}

}  // namespace tocsin::deployment
