// SPDX-License-Identifier: Apache-2.0
#include "running_system.hpp"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <utility>

#include "command_line/host_option.hpp"
#include "command_line/programs.hpp"
#include "deployment/running_host.hpp"
#include "foundation/error.hpp"

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

/// Becomes the process; only async-signal-safe calls between fork and here.
[[noreturn]] void become(const std::vector<std::string>& command) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::signal(SIGINT, SIG_DFL);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execv(words[0], words.data());
  ::_exit(127);
}

/// Ctrl-C reaches both; the child ends by it, and then this program.
int run_and_wait(const std::vector<std::string>& command) {
  ::signal(SIGINT, SIG_IGN);
  const pid_t child = ::fork();
  if (child < 0) throw EnvironmentError("cannot start a process: fork failed");
  if (child == 0) become(command);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

void JoinOptions::declare(CLI::App& app) {
  app.add_option("--run-dir", run_dir, "folder of the run to join [the newest in runs/]");
  add_host_option(app, host, "side of the link to join")->capture_default_str();
}

std::string newest_run(const std::string& runs) {
  std::string newest;
  std::error_code absent;
  for (const auto& entry : fs::directory_iterator(runs, absent)) {
    const bool is_run = fs::exists(entry.path() / "processes.json", absent);
    if (is_run) newest = std::max(newest, entry.path().string());  // named by their time
  }
  if (newest.empty()) {
    throw EnvironmentError("no run in " + runs + ": tocsin launch makes one, --run-dir names it");
  }
  return newest;
}

deployment::Deployment with_guest(deployment::Deployment deployment, const std::string& given,
                                  const Guest& guest) {
  const std::string host = deployment::host_named(deployment, given).name;
  const auto found = std::find_if(deployment.hosts.begin(), deployment.hosts.end(),
                                  [&](const auto& one) { return one.name == host; });
  for (deployment::Container& other : found->containers) other.terminal = false;
  deployment::Container container;
  container.name = guest_name();
  container.components.push_back(
      {guest.component, guest.component + "_operator", parameters_of(guest, deployment.sources)});
  found->containers.push_back(std::move(container));
  return deployment;
}

int run_guest(const JoinOptions& options, const Guest& guest) {
  const fs::path run = fs::absolute(options.run_dir.empty() ? newest_run("runs") : options.run_dir);
  const std::string original = (run / "deployment.yaml").string();
  if (!fs::exists(original)) throw EnvironmentError(run.string() + ": holds no run");
  const deployment::Deployment joined =
      with_guest(deployment::load_resolved(original), options.host, guest);
  const std::string host = deployment::host_named(joined, options.host).name;
  const auto container = find_program("tocsin-container", program_folders());
  if (!container) throw EnvironmentError("tocsin-container is not installed");
  const pid_t process = deployment::process_of(run, host);
  const std::string file = (run / ("operator-" + std::to_string(::getpid()) + ".yaml")).string();
  deployment::write_resolved(joined, file);
  if (joined.radio) deployment::enter_namespaces(process);
  const int code = run_and_wait({container->string(), file, host, guest_name()});
  std::error_code ignored;
  fs::remove(file, ignored);
  return code;
}

}  // namespace tocsin
