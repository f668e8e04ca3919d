// SPDX-License-Identifier: Apache-2.0
#include "running_system.hpp"

#include <signal.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "command_line/host_option.hpp"
#include "command_line/programs.hpp"
#include "deployment/resolved_copy.hpp"
#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/role.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

/// Of the guest's process; several commands may run at a time.
std::string guest_name() { return "console_" + std::to_string(::getpid()); }

std::shared_ptr<const YAML::Node> parameters_of(const Guest& guest, YamlSources& sources) {
  auto node = std::make_shared<YAML::Node>(YAML::NodeType::Map);
  for (const std::string& setting : guest.settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) {
      throw ConfigError("--set " + setting + ": is not key=value");
    }
    (*node)[setting.substr(0, equals)] =
        sources.parse(setting.substr(equals + 1), "--set " + setting);
  }
  return node;
}

/// Ctrl-C reaches both; the child ends by it, and then this program.
int run_and_wait(const std::vector<std::string>& command) {
  ::signal(SIGINT, SIG_IGN);
  return wait_for_child(start_child({command}).pid);
}

bool is_wanted(const deployment::RunningHost& host, const JoinOptions& options) {
  const bool is_it = host.host == options.host || role_of(options.host) == host.itself().role;
  return is_it && (options.run_dir.empty() || host.is_of(options.run_dir));
}

}  // namespace

void JoinOptions::declare(CLI::App& app, const std::string& without) {
  app.add_option("--run-dir", run_dir, "folder of the run to join [" + without + "]");
  add_host_option(app, host, "side of the link to join")->capture_default_str();
  app.add_option("--vehicle", vehicle, "name of the vehicle, where the station has several");
}

std::vector<std::string> vehicles_of(const JoinOptions& options,
                                     const deployment::Deployment& deployment,
                                     const std::string& host) {
  const auto& all = deployment.vehicles;
  const bool is_vehicle = std::find(all.begin(), all.end(), host) != all.end();
  const bool is_known = std::find(all.begin(), all.end(), options.vehicle) != all.end();
  if (!options.vehicle.empty() && (!is_known || (is_vehicle && host != options.vehicle))) {
    throw ConfigError("--vehicle " + printable(options.vehicle) + ": host " + host +
                      (all.empty() || is_vehicle ? " serves none by name"
                                                 : " serves one of: [" + joined(all) + "]"));
  }
  if (all.empty() || is_vehicle) return {""};
  return options.vehicle.empty() ? all : std::vector<std::string>{options.vehicle};
}

std::vector<deployment::RunningHost> hosts_to_join(const JoinOptions& options,
                                                   deployment::RunningHosts running) {
  std::vector<deployment::RunningHost> found;
  for (deployment::RunningHost& one : running.hosts) {
    if (is_wanted(one, options)) found.push_back(std::move(one));
  }
  return found;
}

deployment::RunningHost host_to_join(const JoinOptions& options, deployment::RunningHosts running) {
  const std::string others =
      running.hidden.empty() ? "" : "; what others have launched cannot be looked into";
  auto found = hosts_to_join(options, std::move(running));
  if (found.empty()) {
    const std::string where =
        options.run_dir.empty() ? "on this computer" : "in " + options.run_dir;
    throw EnvironmentError("no host " + options.host + " runs " + where + others);
  }
  if (found.size() == 1) return std::move(found.front());
  std::string names;
  for (const auto& one : found) {
    names += " --run-dir " + one.deployment.run_dir + " --host " + one.host + ",";
  }
  names.pop_back();
  throw ConfigError("several hosts are " + options.host + "; choose one of:" + names);
}

deployment::Deployment with_guest(deployment::Deployment deployment, const std::string& host,
                                  const Guest& guest, const std::string& vehicle) {
  const auto found = std::find_if(deployment.hosts.begin(), deployment.hosts.end(),
                                  [&](const auto& one) { return one.name == host; });
  for (deployment::Container& other : found->containers) other.terminal = false;
  deployment::Container container;
  container.name = guest_name();
  container.vehicle = vehicle;
  container.components.push_back(
      {guest.component, guest.component + "_operator", parameters_of(guest, deployment.sources)});
  found->containers.push_back(std::move(container));
  return deployment;
}

int run_guest(const JoinOptions& options, const Guest& guest) {
  const auto running = host_to_join(options, deployment::running_hosts());
  const auto vehicles = vehicles_of(options, running.deployment, running.host);
  if (vehicles.size() > 1) {
    throw ConfigError("the station has several vehicles; choose --vehicle " +
                      joined(vehicles, " or "));
  }
  const deployment::ResolvedCopy copy(
      with_guest(running.deployment, running.host, guest, vehicles.front()));
  const auto container = find_program("tocsin-container", program_folders());
  if (!container) throw EnvironmentError("tocsin-container is not installed");
  deployment::enter_namespaces(running.process);
  return run_and_wait(
      {container->string(), running.deployment.file, running.host, guest_name(), copy.path()});
}

}  // namespace tocsin
