// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "deployment/deployment.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "launcher.hpp"
#include "programs.hpp"
#include "run_folder.hpp"

namespace tocsin::cli {
namespace {

struct Options {
  std::string file;
  deployment::Overrides overrides;
  int domain = -1;
  bool only_check = false;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("FILE", options.file, "bringup file; a bare name is also looked for in the share")
      ->required();
  app.add_option("--set", options.overrides.set, "parameter of a component: name.key=value")
      ->expected(1)
      ->take_all();
  app.add_option("--without", options.overrides.without, "host/process that is left out")
      ->expected(1)
      ->take_all();
  app.add_option("--run-dir", options.overrides.run_dir, "folder of the run [runs/<UTC time>]");
  app.add_option("--seed", options.overrides.seed, "value of ${seed}")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--channel", options.overrides.channel,
                 "channel file of the radio, in place of the file's");
  app.add_option("--domain", options.domain,
                 "first of three DDS domain ids, in place of the file's")
      ->check(CLI::Range(0, 229));
}

/// The file as given, or the one of that name in the installed share.
std::string locate(const std::string& file, const std::string& share) {
  namespace fs = std::filesystem;
  const fs::path shared = fs::path(share) / "bringup" / file;
  const bool bare = file.find('/') == std::string::npos;
  return bare && !fs::exists(file) && fs::exists(shared) ? shared.string() : file;
}

bool owns_terminal(const deployment::Deployment& deployment) {
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      if (container.terminal) return true;
    }
  }
  return false;
}

int launch(Options& options) {
  deployment::Overrides& overrides = options.overrides;
  overrides.share = share_folder(own_program()).string();
  if (options.domain >= 0) overrides.domain = options.domain;
  const std::string file = locate(options.file, overrides.share);
  // Checked before the folder of the run is made: a wrong file leaves nothing behind.
  (void)deployment::load_deployment(file, overrides);
  overrides.run_dir = make_run_folder(overrides.run_dir).string();
  const deployment::Deployment deployment = deployment::load_deployment(file, overrides);
  const Folders folders = program_folders();
  const std::string resolved = overrides.run_dir + "/deployment.yaml";
  const auto specs = plan_processes(deployment, resolved, folders);
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
  return launcher.run();
}

int body(int argc, char** argv) {
  CLI::App app{"Start the processes of a bringup file and keep them running"};
  app.name("tocsin launch");
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw ConfigError(error.what());
  }
  return launch(options);
}

}  // namespace
}  // namespace tocsin::cli

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin launch", [&] { return tocsin::cli::body(argc, argv); });
}
