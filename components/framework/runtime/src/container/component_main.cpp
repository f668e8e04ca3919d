// SPDX-License-Identifier: Apache-2.0
// tocsin component types | info | list | load | unload | configure | activate | ...
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "command_line/host_option.hpp"
#include "container/settings.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/container_client.hpp"
#include "runtime/middleware/host_bus.hpp"

namespace tocsin {
namespace {

using Known = ContainerClient::Known;

struct Options {
  HostChoice host;
  std::string container;
  std::string component;
  std::string name;
  std::vector<std::string> set;
  double timeout_s = 5;
};

int types() {
  const auto components = installed_components();
  std::size_t widest = 0;
  for (const auto& one : components) widest = std::max(widest, one.name.size());
  for (const auto& one : components) {
    fmt::print("{:<{}}  {}\n", one.name, widest, printable(one.package));
  }
  return 0;
}

int info(const std::string& name) {
  std::printf("%s:\n", name.c_str());
  const std::string defaults = load_component(name).defaults();
  for (std::size_t at = 0; at < defaults.size();) {
    const std::size_t end = defaults.find('\n', at);
    std::printf("  %s\n", defaults.substr(at, end - at).c_str());
    at = end + 1;
  }
  return 0;
}

void print(const ContainerClient::State& state) {
  fmt::print("/{}/{}  process {}\n", printable(state.host()), printable(state.container()),
             state.pid());
  for (const auto& one : state.components()) {
    const std::string error = one.error().empty() ? "" : ": " + one.error();
    fmt::print("  {}  /{}  {}  {}{}\n", one.id(), printable(one.name()), printable(one.library()),
               printable(one.state()), error_line(error));
  }
}

/// Every container tells its state once a second.
int list(const Options& options) {
  const auto bus = open_host_bus(options.host, "tocsin_component");
  ContainerClient client(*bus);
  const Known known = client.wait(seconds(1.5), [](const Known&) { return false; });
  if (known.empty()) throw EnvironmentError("no container runs on this host");
  for (const auto& one : known) print(one.second);
  return 0;
}

/// The one of `paths_of(known)` that `given` means, once it has been heard.
template <class Paths>
std::vector<std::string> find(ContainerClient& client, const Options& options,
                              const std::string& given, const Paths& paths_of, const char* what) {
  const auto heard = [&](const Known& known) {
    const auto paths = paths_of(known);
    return std::any_of(paths.begin(), paths.end(),
                       [&given](const std::string& path) { return means(given, path); });
  };
  const Known known = client.wait(seconds(options.timeout_s), heard);
  return words_of_path(resolve_path(given, paths_of(known), what));
}

/// Who a command is for.
struct Target {
  std::string container;
  std::string instance;
};

Target find_target(ContainerClient& client, const Options& options) {
  if (options.container.empty()) {
    const auto words = find(client, options, options.name, instance_paths, "component");
    return {words[1], words[2]};
  }
  const std::string& given = options.name.empty() ? options.component : options.name;
  const auto words = find(client, options, options.container, container_paths, "container");
  const auto instance = words_of_path(given);
  return {words[1], instance.empty() ? given : instance.back()};
}

int ask(const std::string& verb, Options& options) {
  options.host.adopt_host_of(options.container.empty() ? options.name : options.container);
  const auto bus = open_host_bus(options.host, "tocsin_component");
  ContainerClient client(*bus);
  const Target target = find_target(client, options);
  ContainerClient::Command command;
  command.container(target.container);
  command.verb(verb);
  command.library(options.component);
  command.name(target.instance);
  command.parameters(settings_text(options.set));
  const auto answer = client.ask(command, seconds(options.timeout_s));
  if (!answer.done()) throw ConfigError(answer.text());
  std::string text = answer.text();
  if (verb == "load" || verb == "unload") {
    text += (verb == "load" ? " into container " : " from container ") + command.container();
  }
  std::printf("%s\n", error_line(text).c_str());
  return 0;
}

CLI::App* declare(CLI::App& app, const std::string& verb, const std::string& text,
                  Options& options) {
  CLI::App* const command = app.add_subcommand(verb, text);
  options.host.declare(*command);
  command->add_option("--timeout", options.timeout_s, "[s] for an answer")
      ->check(CLI::Range(0.1, 60.0));
  return command;
}

void declare_load(CLI::App& app, Options& options) {
  CLI::App* const load = declare(app, "load", "put a component into a running container", options);
  load->add_option("CONTAINER", options.container, "see list")->required();
  add_name_option(*load, "COMPONENT", options.component, "see types")->required();
  load->add_option("--name", options.name, "of the instance [COMPONENT]");
  load->add_option("--set", options.set, "parameter: key=value")->expected(1)->take_all();
}

void declare_changes(CLI::App& app, Options& options) {
  for (const char* verb : {"configure", "activate", "deactivate", "cleanup", "shutdown"}) {
    CLI::App* const one = declare(app, verb, "lifecycle transition of a component", options);
    one->add_option("NAME", options.name, "instance, see list")->required();
    one->add_option("--container", options.container, "that has it [found by the name]");
  }
}

int run(int argc, char** argv) {
  CLI::App app("Components: installed ones, and those of running containers", "tocsin component");
  app.require_subcommand(1);
  Options options;
  app.add_subcommand("types", "names of all installed components");
  CLI::App* const info_of = app.add_subcommand("info", "parameters with default, unit and range");
  add_name_option(*info_of, "COMPONENT", options.component, "see types")->required();
  declare(app, "list", "running containers with their components and states", options);
  declare_load(app, options);
  CLI::App* const unload = declare(app, "unload", "take a component out of its container", options);
  unload->add_option("CONTAINER", options.container, "see list")->required();
  unload->add_option("NAME", options.name, "instance or its number, see list")->required();
  declare_changes(app, options);
  return run_command(app, argc, argv, [&] {
    const std::string verb = app.get_subcommands().front()->get_name();
    if (verb == "types") return types();
    if (verb == "info") return info(options.component);
    return verb == "list" ? list(options) : ask(verb, options);
  });
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) { return tocsin::run(argc, argv); }
