// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "check_first.hpp"
#include "command_line/bringup_options.hpp"
#include "command_line/command.hpp"
#include "command_line/launch_plan.hpp"
#include "command_line/programs.hpp"
#include "deployment/deployment.hpp"
#include "deployment/resolved_copy.hpp"
#include "deployment/run_folder.hpp"
#include "foundation/error.hpp"
#include "launcher.hpp"
#include "served_port.hpp"

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

int launch(BringupOptions& options) {
  options.locate();
  deployment::Overrides& overrides = options.overrides;
  const std::string& file = options.file;
  // Checked before the folder of the run is made: a wrong file leaves nothing behind.
  const Folders folders = program_folders();
  if (!may_start(options, folders)) return 2;
  const deployment::RunFolder run(overrides.run_dir);
  overrides.run_dir = run.path().string();
  const deployment::Deployment deployment = deployment::load_deployment(file, overrides);
  const std::string resolved = overrides.run_dir + "/deployment.yaml";
  const deployment::ResolvedCopy copy(deployment);
  const auto specs = plan_processes(deployment, {resolved, copy.path()}, folders);
  auto ports = served_ports(deployment);
  listen_for(ports);
  std::vector<HostNetwork> networks;
  if (deployment.radio) {
    enter_private_world();
    networks = std::vector<HostNetwork>(deployment.hosts.size());
  }
  deployment::write_resolved(deployment, resolved);
  Signals signals;
  Journal journal(overrides.run_dir + "/log", !owns_terminal(deployment),
                  ::isatty(STDOUT_FILENO) == 1);
  Launcher launcher(deployment, networks, signals, journal);
  if (deployment.radio) {
    std::vector<int> descriptors;
    for (const HostNetwork& network : networks) descriptors.push_back(network.descriptor());
    launcher.add(plan_radio(deployment, descriptors, folders));
  }
  for (const ProcessSpec& spec : specs) launcher.add(spec);
  launcher.serve(std::move(ports));
  return launcher.run();
}

}  // namespace
}  // namespace tocsin::cli

int main(int argc, char** argv) {
  CLI::App app{"Start the processes of a bringup file and keep them running", "tocsin launch"};
  tocsin::BringupOptions options;
  options.declare(app);
  app.add_option("--run-dir", options.overrides.run_dir, "folder of the run [runs/<UTC time>]");
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::cli::launch(options); });
}
