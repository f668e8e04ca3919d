// SPDX-License-Identifier: Apache-2.0
#include <linux/capability.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "check_first.hpp"
#include "command_line/bringup_options.hpp"
#include "command_line/command.hpp"
#include "command_line/launch_plan.hpp"
#include "command_line/launch_user.hpp"
#include "command_line/programs.hpp"
#include "deployment/deployment.hpp"
#include "deployment/resolved_copy.hpp"
#include "domains_line.hpp"
#include "foundation/error.hpp"
#include "foundation/privileges.hpp"
#include "launcher.hpp"
#include "open_link.hpp"
#include "run_folder.hpp"
#include "run_place.hpp"
#include "served_port.hpp"
#include "service_manager.hpp"

namespace tocsin::cli {
namespace {

bool owns_terminal(const deployment::Deployment& deployment) {
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      if (container.terminal) return true;
    }
  }
  return false;
}

bool has_containers(const deployment::Deployment& deployment) {
  return std::any_of(deployment.hosts.begin(), deployment.hosts.end(),
                     [](const deployment::Host& host) { return !host.containers.empty(); });
}

/// All that is found before anything starts is what `tocsin check` finds. False when it refuses,
/// and has said why. Throws ConfigError when that program is not there and needed.
bool may_start(const BringupOptions& options, const Folders& folders) {
  const auto checker = find_program("tocsin-check", folders);
  if (checker && !check_first(options, *checker)) return false;
  const auto deployment = deployment::load_deployment(options.file, options.overrides);
  if (!checker && has_containers(deployment)) {
    throw ConfigError("tocsin-check is not found beside tocsin-launch or in $PATH");
  }
  (void)plan_processes(deployment, {}, folders);
  return true;
}

/// The folder that is there already, above the one that is to be made.
std::filesystem::path place_of(const std::string& run_dir) {
  std::filesystem::path place = std::filesystem::absolute(run_dir.empty() ? "runs" : run_dir);
  do {
    place = place.parent_path();
  } while (!std::filesystem::exists(place));
  return place;
}

/// What the user of a launch must be able to read or reach.
std::vector<Access> needed_by(const BringupOptions& options,
                              const deployment::Deployment& deployment) {
  std::vector<Access> all{{own_program(), R_OK | X_OK},
                          {options.file, R_OK},
                          {place_of(options.overrides.run_dir), X_OK}};
  if (std::filesystem::exists(deployment.share)) all.push_back({deployment.share, R_OK | X_OK});
  for (const std::string& file : {deployment.qos, deployment.traffic}) {
    if (!file.empty()) all.push_back({file, R_OK});
  }
  for (const deployment::Host& host : deployment.hosts) {
    const std::filesystem::path key = deployment::enclave_of(deployment, host) + "/key.pem";
    if (std::filesystem::exists(key)) all.push_back({key, R_OK});
  }
  return all;
}

/// Root's launch becomes the ordinary user of the run, when there is one.
UserChoice become_ordinary(const BringupOptions& options, const std::string& wanted) {
  deployment::Deployment deployment;
  try {
    deployment = deployment::load_deployment(options.file, options.overrides);
  } catch (const ConfigError&) {
    return {};  // the check says it, and nothing starts
  }
  const UserChoice choice = choose_user(wanted, deployment.user, needed_by(options, deployment));
  // For the folder of the run, and for an emulated radio.
  if (choice.account) {
    become_user(*choice.account, {CAP_CHOWN, CAP_DAC_OVERRIDE, CAP_SYS_ADMIN, CAP_NET_ADMIN});
  }
  return choice;
}

/// The folder of the run belongs to its user, wherever it lies.
ChosenRunFolder make_run_folder(const std::string& wanted, const UserChoice& user) {
  const AwakeCapabilities awake;
  if (user.account) give_empty_folder(wanted);
  return choose_run_folder(wanted, run_place());
}

/// Gives each host a network of its own, when the radio is emulated.
std::vector<HostNetwork> make_networks(const deployment::Deployment& deployment) {
  if (!deployment.radio) return {};
  const AwakeCapabilities awake;
  enter_private_world();
  return std::vector<HostNetwork>(deployment.hosts.size());
}

void add_radios(const deployment::Deployment& deployment, const std::vector<HostNetwork>& networks,
                const Folders& folders, Launcher& launcher) {
  std::vector<int> descriptors;
  for (const HostNetwork& network : networks) descriptors.push_back(network.descriptor());
  for (const ProcessSpec& spec : plan_radios(deployment, descriptors, folders)) {
    launcher.add(spec);
  }
}

struct LaunchOptions {
  BringupOptions bringup;
  std::string user;
};

int launch(LaunchOptions& given) {
  ServiceManager service;
  BringupOptions& options = given.bringup;
  options.locate();
  deployment::Overrides& overrides = options.overrides;
  const std::string& file = options.file;
  const UserChoice user = become_ordinary(options, given.user);
  // Checked before the folder of the run is made: a wrong file leaves nothing behind.
  const Folders folders = program_folders();
  if (!may_start(options, folders)) return 2;
  const ChosenRunFolder run = make_run_folder(overrides.run_dir, user);
  overrides.run_dir = run.folder.path().string();
  const deployment::Deployment deployment = deployment::load_deployment(file, overrides);
  if (user.account) keep_only(deployment.radio ? radio_capabilities : Capabilities{});
  const std::string resolved = overrides.run_dir + "/deployment.yaml";
  const deployment::ResolvedCopy copy(deployment);
  const auto specs = plan_processes(deployment, {resolved, copy.path()}, folders);
  auto ports = served_ports(deployment);
  listen_for(ports);
  const std::vector<HostNetwork> networks = make_networks(deployment);
  deployment::write_resolved(deployment, resolved);
  deployment::write_parts(deployment);
  Signals signals;
  Journal journal(overrides.run_dir + "/log", !owns_terminal(deployment),
                  ::isatty(STDOUT_FILENO) == 1);
  journal.say(domains_line(deployment));
  for (const std::string& warning : {user.warning, run.warning}) {
    if (!warning.empty()) journal.say(warning);
  }
  if (const auto warning = open_link_warning(deployment)) journal.say(*warning);
  Launcher launcher(deployment, networks, signals, journal, service);
  if (deployment.radio) add_radios(deployment, networks, folders, launcher);
  for (const ProcessSpec& spec : specs) launcher.add(spec);
  launcher.serve(std::move(ports));
  return launcher.run();
}

}  // namespace
}  // namespace tocsin::cli

int main(int argc, char** argv) {
  CLI::App app{"Start the processes of a bringup file and keep them running", "tocsin launch"};
  tocsin::cli::LaunchOptions options;
  options.bringup.declare(app);
  app.add_option("--run-dir", options.bringup.overrides.run_dir,
                 "folder of the run [runs/<UTC time>]");
  app.add_option(
      "--user", options.user,
      "whom root becomes for all of it, in place of the file's [who called sudo, tocsin]");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::cli::launch(options); });
}
