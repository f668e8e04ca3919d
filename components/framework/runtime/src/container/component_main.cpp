// SPDX-License-Identifier: Apache-2.0
// tocsin component types | info | list | load | unload
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
#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_sources.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/container_states.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "runtime/middleware/ros_parameters.hpp"
#include "runtime/middleware/ros_services.hpp"
#include "runtime/middleware/service_caller.hpp"

namespace tocsin {
namespace {

using Known = ContainerStates::Known;

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

void print(const ContainerStates::State& state) {
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
  ContainerStates states(*bus);
  const Known known = states.wait(seconds(1.5), [](const Known&) { return false; });
  if (known.empty()) throw EnvironmentError("no container runs on this host");
  for (const auto& one : known) print(one.second);
  return 0;
}

/// The one of `paths_of(known)` that `given` means, once it has been heard. Throws EnvironmentError
/// when it is not there, ConfigError when several are meant.
template <class Paths>
std::vector<std::string> find(ContainerStates& states, const Options& options,
                              const std::string& given, const Paths& paths_of, const char* what) {
  const auto heard = [&](const Known& known) {
    const auto paths = paths_of(known);
    return std::any_of(paths.begin(), paths.end(),
                       [&given](const std::string& path) { return means(given, path); });
  };
  const Known known = states.wait(seconds(options.timeout_s), heard);
  try {
    return words_of_path(resolve_path(given, paths_of(known), what));
  } catch (const ConfigError& error) {
    if (heard(known)) throw;  // more than one is meant
    throw EnvironmentError(error.what());
  }
}

/// The container that `options` mean.
std::string find_container(ContainerStates& states, const Options& options) {
  return find(states, options, options.container, container_paths, "container")[1];
}

/// `text` in YAML's words, as the service has it.
std::vector<rcl_interfaces::msg::Parameter> parameters_in(const std::string& text) {
  std::vector<rcl_interfaces::msg::Parameter> parameters;
  YamlSources sources;
  for (const auto& entry : sources.parse(text, "--set")) {
    rcl_interfaces::msg::Parameter one;
    one.name(entry.first.Scalar());
    one.value(ros_value_of(entry.second, "--set " + printable(one.name())));
    parameters.push_back(std::move(one));
  }
  return parameters;
}

/// `/gcs/drive/lamp`, `/lamp` and `lamp` are the instance `lamp`.
std::string bare(const std::string& instance) {
  const auto words = words_of_path(instance);
  return words.empty() ? instance : words.back();
}

int load(const Options& options, Bus& bus) {
  ContainerStates states(bus);
  const std::string node = container_node(find_container(states, options));
  composition_service::LoadNode::Request request;
  request.plugin_name(options.component);
  request.node_name(bare(options.name));
  request.parameters(parameters_in(settings_text(options.set)));
  const auto response = call_service<composition_service::LoadNode>(bus, node, std::move(request),
                                                                    seconds(options.timeout_s));
  if (!response->success()) throw ConfigError(printable(response->error_message()));
  fmt::print("Loaded component {} into '/{}' container node as '{}'\n", response->unique_id(), node,
             printable(response->full_node_name()));
  return 0;
}

/// The number of the instance; it may have been given by its number. Throws EnvironmentError.
std::uint32_t number_of(const Known& known, const std::string& container,
                        const std::string& instance) {
  std::vector<std::string> names;
  for (const auto& [process, state] : known) {
    if (process.first != container) continue;
    for (const auto& one : state.components()) {
      if (one.name() == instance || std::to_string(one.id()) == instance) return one.id();
      names.push_back(one.name());
    }
  }
  throw EnvironmentError(printable(instance) + ": no such component; allowed: [" +
                         joined(names, ", ") + "]" + suggestion(names, instance));
}

int unload(const Options& options, Bus& bus) {
  ContainerStates states(bus);
  const std::string container = find_container(states, options);
  const std::string node = container_node(container);
  const auto known = states.wait(Duration::zero(), [](const Known&) { return true; });
  composition_service::UnloadNode::Request request;
  request.unique_id(number_of(known, container, bare(options.name)));
  const auto number = request.unique_id();
  const auto response = call_service<composition_service::UnloadNode>(bus, node, std::move(request),
                                                                      seconds(options.timeout_s));
  if (!response->success()) throw ConfigError(printable(response->error_message()));
  fmt::print("Unloaded component {} from '/{}' container node\n", number, node);
  return 0;
}

int ask(const std::string& verb, Options& options) {
  options.host.adopt_host_of(options.container);
  const auto bus = open_host_bus(options.host, "tocsin_component");
  return verb == "load" ? load(options, *bus) : unload(options, *bus);
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
