// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/host_bus.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "command_line/host_option.hpp"
#include "command_line/programs.hpp"
#include "deployment/deployment.hpp"
#include "deployment/running_host.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {
namespace {

/// A file of a run, which may be another user's: a FIFO would wait for a writer.
const std::string& regular(const std::string& path) {
  std::error_code unreadable;
  if (std::filesystem::is_regular_file(path, unreadable)) return path;
  throw ConfigError(path + ": the run's file is not there any more, or is none");
}

BusOptions options_of_run(const deployment::RunningHost& running) {
  deployment::enter_namespaces(running.process);
  BusOptions options;
  options.role = running.itself().role;
  options.ros_namespace = running.deployment.ros_namespace;
  options.qos_file = regular(running.deployment.qos);
  options.traffic_file = regular(running.deployment.traffic);
  options.host_domain = running.itself().local_domain;
  return options;
}

BusOptions installed_options() {
  const std::string config = share_folder(own_program()).string() + "/config/";
  BusOptions options;
  options.qos_file = config + "qos.yaml";
  options.traffic_file = config + "traffic.yaml";
  options.host_domain = default_domain();
  return options;
}

bool is_set(const char* variable) {
  const char* const text = std::getenv(variable);
  return text != nullptr && *text != '\0';
}

/// The run that was named; else, when no domain was, the only one on this computer.
std::optional<deployment::RunningHost> chosen_run(const HostChoice& choice) {
  if (!choice.run_dir.empty()) return deployment::running_host(choice.run_dir, choice.host);
  if (choice.domain || is_set("ROS_DOMAIN_ID")) return std::nullopt;
  const auto running = deployment::running_hosts();
  if (running.hosts.empty()) return std::nullopt;
  const std::string& run_dir = running.hosts.front().deployment.run_dir;
  for (const deployment::RunningHost& one : running.hosts) {
    if (one.is_of(run_dir)) continue;
    throw ConfigError("several systems run here: choose one with --run-dir " + run_dir + ", " +
                      one.deployment.run_dir + " or --domain");
  }
  return deployment::running_host(run_dir, choice.host);
}

}  // namespace

void HostChoice::declare(CLI::App& app) {
  app.add_option(
         "--domain", domain,
         "DDS domain of the host [of --run-dir, $ROS_DOMAIN_ID, the run on this computer, 0]")
      ->check(CLI::Range(0, 231));
  app.add_option("--run-dir", run_dir, "folder of a run of tocsin launch");
  add_host_option(app, host, "host of that run [its first]");
  add_name_option(app, "--namespace", ros_namespace,
                  "ROS namespace of the topics: at a station of several vehicles the name of one");
}

void HostChoice::adopt_host_of(const std::string& name) {
  const auto words = words_of_path(name);
  if (!host.empty() || run_dir.empty() || words.size() < 2) return;
  for (const auto& one : deployment::running_hosts().hosts) {
    const bool has_it = deployment::find_host(one.deployment, words.front()) != nullptr;
    if (has_it && one.is_of(run_dir)) host = words.front();
  }
}

int default_domain() {
  const char* const text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return 0;
  char* end = nullptr;
  const long domain = std::strtol(text, &end, 10);
  if (*end != '\0' || domain < 0 || domain > 231) {
    throw ConfigError(std::string("ROS_DOMAIN_ID: '") + text + "' is not a number in [0, 231]");
  }
  return static_cast<int>(domain);
}

BusOptions host_bus_options(const HostChoice& choice, const std::string& name) {
  const auto run = chosen_run(choice);
  BusOptions options = run ? options_of_run(*run) : installed_options();
  options.name = name;
  if (!choice.ros_namespace.empty()) options.ros_namespace = choice.ros_namespace;
  if (choice.domain) options.host_domain = *choice.domain;
  return options;
}

std::unique_ptr<deployment::RunningHost> chosen_host(const HostChoice& choice) {
  auto run = chosen_run(choice);
  return run ? std::make_unique<deployment::RunningHost>(std::move(*run)) : nullptr;
}

std::unique_ptr<Bus> open_host_bus(const HostChoice& choice, const std::string& name) {
  return make_fast_dds_bus(host_bus_options(choice, name));
}

}  // namespace tocsin
