// SPDX-License-Identifier: Apache-2.0
#include "estop_target.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "operator_console/emergency_stop_order.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

/// `vehicle`: of several that the host serves; empty: it serves none by name.
BusOptions bus_of(const deployment::Deployment& whole, const std::string& host_name,
                  const std::string& vehicle) {
  const auto deployment = part_of(whole, vehicle.empty() ? host_name : vehicle);
  const deployment::Host& host = *find_host(deployment, host_name);
  deployment::Container place;
  place.vehicle = vehicle;
  BusOptions bus;
  bus.name = EmergencyStopOrder::process;
  bus.role = host.role;
  bus.ros_namespace = namespace_of(deployment, host, place);
  bus.host_domain = host.local_domain;
  bus.link_domain = deployment.link_domain;
  bus.link_address = host.address;
  bus.link_peers = host.peers;
  if (host.second) {
    bus.second_address = host.second->address;
    bus.second_peers = host.second->peers;
  }
  bus.enclave = enclave_of(deployment, host);
  bus.host = "estop";
  return bus;
}

/// Where no station is, so that an order for the vehicle itself reaches no other station.
int nobodys_domain(std::optional<int> link_domain) { return link_domain == 231 ? 230 : 231; }

bool names_domains(const EstopOptions& options) { return options.domain || options.link_domain; }

EstopTarget target_of(const EstopOptions& options) {
  const bool has_link = options.link_domain.has_value();
  if (has_link == options.address.empty() || has_link == options.peers.empty()) {
    throw ConfigError("--link-domain, --address and --peer belong together");
  }
  BusOptions bus;
  bus.name = EmergencyStopOrder::process;
  bus.role = role_of(options.join.host).value_or(Role::gcs);
  bus.ros_namespace = options.ros_namespace;
  bus.host_domain = options.domain.value_or(nobodys_domain(options.link_domain));
  if (has_link) {
    bus.link_domain = *options.link_domain;
    bus.link_address = options.address;
    bus.link_peers = options.peers;
    bus.enclave = options.enclave;
    bus.host = "estop";
    bus.role = Role::gcs;
    bus.traffic_file = share_folder(own_program()) / "config/traffic.yaml";
  }
  return {"", std::nullopt, std::move(bus), has_link};
}

/// The options that mean one vehicle of a run.
std::string choice_of(const std::string& run_dir, const std::string& vehicle) {
  return "--run-dir " + run_dir + (vehicle.empty() ? "" : " --vehicle " + vehicle);
}

/// One for each vehicle of the station.
std::vector<EstopTarget> targets_of(const EstopOptions& options,
                                    const deployment::RunningHost& running) {
  const std::string& run_dir = running.deployment.run_dir;
  std::vector<EstopTarget> targets;
  for (const std::string& vehicle : vehicles_of(options.join, running.deployment, running.host)) {
    targets.push_back({run_dir + (vehicle.empty() ? "" : " " + vehicle), running.process,
                       bus_of(running.deployment, running.host, vehicle), false,
                       choice_of(run_dir, vehicle)});
  }
  return targets;
}

/// Who lets vehicles drive again says which.
void refuse_several(const std::vector<EstopTarget>& targets) {
  if (targets.size() < 2) return;
  std::vector<std::string> choices;
  for (const EstopTarget& one : targets) choices.push_back(one.choice);
  throw ConfigError("several vehicles are meant, and off lets a vehicle drive: choose " +
                    joined(choices) + ", or --all");
}

/// Folders of runs, newest first: they are named by their time.
std::vector<fs::path> runs_here() {
  std::vector<fs::path> folders;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator("runs", absent)) folders.push_back(entry.path());
  std::sort(folders.rbegin(), folders.rend());
  return folders;
}

/// A station that does not run any more, but whose file still tells how its vehicles are reached.
/// An emulated radio ends with its launcher.
std::vector<EstopTarget> targets_of_file(const EstopOptions& options, const fs::path& run) {
  std::vector<EstopTarget> targets;
  const std::string& name = options.join.host;
  try {
    const auto deployment = deployment::load_resolved(run / "deployment.yaml");
    for (const deployment::Host& host : deployment.hosts) {
      const bool is_it = host.name == name || role_of(name) == host.role;
      if (!is_it || deployment.radio) continue;
      const bool routed = deployment::is_routed(host);
      for (const std::string& vehicle : vehicles_of(options.join, deployment, host.name)) {
        BusOptions bus = bus_of(deployment, host.name, vehicle);
        if (routed) bus.traffic_file = deployment.traffic;
        const std::string of = vehicle.empty() ? "" : " " + vehicle;
        targets.push_back({run.string() + of + ", which does not run", std::nullopt, bus, routed,
                           choice_of(run.string(), vehicle)});
      }
      return targets;
    }
  } catch (const ConfigError&) {  // holds no run, or cannot be read
  }
  return targets;
}

std::vector<EstopTarget> targets_that_ran(const EstopOptions& options) {
  const JoinOptions& join = options.join;
  if (!join.run_dir.empty()) return targets_of_file(options, join.run_dir);
  for (const fs::path& run : runs_here()) {
    auto targets = targets_of_file(options, run);
    if (!targets.empty()) return targets;
  }
  return {};
}

/// Of what runs here, else of what ran here last.
std::vector<EstopTarget> targets_here(const EstopOptions& options,
                                      deployment::RunningHosts running) {
  std::vector<EstopTarget> targets;
  for (const auto& one : hosts_to_join(options.join, running)) {
    for (EstopTarget& target : targets_of(options, one)) targets.push_back(std::move(target));
  }
  if (!targets.empty()) return targets;
  try {
    return targets_of(options, host_to_join(options.join, std::move(running)));
  } catch (const EnvironmentError& nothing_runs) {
    targets = targets_that_ran(options);
    if (targets.empty()) {
      throw EnvironmentError(std::string(nothing_runs.what()) +
                             "; --link-domain, --address and --peer reach a vehicle all the same");
    }
  }
  return targets;
}

}  // namespace

void EstopOptions::declare(CLI::App& app) {
  join.declare(app, "on, status: each that runs here; off: the only one that does");
  app.add_flag("--all", all, "with off: the stops of all vehicles of all stations that run here");
  app.add_option("--domain", domain, "DDS domain of the station's host, in place of a run")
      ->check(CLI::Range(0, 231));
  app.add_option("--link-domain", link_domain,
                 "DDS domain of the link: tells the vehicle itself; with --address and --peer")
      ->check(CLI::Range(0, 231));
  app.add_option("--address", address, "own IPv4 address on the link");
  app.add_option("--peer", peers, "IPv4 address of the vehicle on the link")
      ->expected(1)
      ->take_all();
  app.add_option("--enclave", enclave,
                 "folder of the identity with which a secured link lets it in")
      ->check(CLI::ExistingDirectory);
  app.add_option("--namespace", ros_namespace, "ROS namespace of the topics, with a domain");
}

std::vector<EstopTarget> find_targets(const EstopOptions& options, Among among,
                                      deployment::RunningHosts running) {
  if (names_domains(options)) return {target_of(options)};
  auto targets = targets_here(options, std::move(running));
  if (among == Among::only_one && !options.all) refuse_several(targets);
  return targets;
}

}  // namespace tocsin
