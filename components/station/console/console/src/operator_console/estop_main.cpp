// SPDX-License-Identifier: Apache-2.0
// tocsin estop on | off | status
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "command_line/command.hpp"
#include "estop_target.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "operator_console/operator_console_component.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin {
namespace {

constexpr auto tick_period = std::chrono::milliseconds(10);

using Params = OperatorConsoleComponent::Params;

/// The order's own way over the link. It ends with the order.
std::unique_ptr<Component> make_router(Context& context) {
  return load_component("link_router").create(context, YAML::Node(YAML::NodeType::Map), {});
}

/// Of several targets each line says of which it is.
void print_of(const std::string& name, const std::string& line) {
  std::printf("%s\n", error_line((name.empty() ? "" : name + ": ") + line).c_str());
  std::fflush(stdout);
}

/// Where the own router keeps the key of a press, by which a later order releases it: in
/// $XDG_STATE_HOME/tocsin or ~/.local/state/tocsin. Empty when there is neither: then it must be
/// released at the vehicle.
std::string keys_folder() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value == '/' ? std::string(value) : std::string();
  };
  std::string folder = variable("XDG_STATE_HOME");
  if (folder.empty() && !variable("HOME").empty()) folder = variable("HOME") + "/.local/state";
  if (folder.empty()) return folder;
  std::error_code failed;
  std::filesystem::create_directories(folder + "/tocsin", failed);
  return failed ? "" : folder + "/tocsin";
}

/// Gives the order in this process; its exit code. `name`: in front of what it prints.
int give(const EstopTarget& target, const Params& params, const std::string& name) {
  if (target.process) deployment::enter_namespaces(*target.process);
  const auto bus = make_fast_dds_bus(target.bus);
  std::optional<int> code;
  Context context = Context(*bus, "estop", target.bus.role).with_request_exit([&code](int wanted) {
    code = wanted;
  });
  Context router_context =
      Context(*bus, "estop_router", target.bus.role).with_run_dir(keys_folder());
  const auto router = target.needs_router ? make_router(router_context) : nullptr;
  OperatorConsoleComponent order(context, params,
                                 [&name](const std::string& line) { print_of(name, line); });
  while (!code) {
    if (router) router->tick(bus->now());
    order.tick(bus->now());
    std::this_thread::sleep_for(tick_period);
  }
  return *code;
}

/// Each in a process of its own, as each has a network of its own, which a process enters before it
/// has threads: a fork without a program. The greatest exit code.
int give_all(const std::vector<EstopTarget>& targets, const Params& params) {
  if (targets.size() == 1) return give(targets.front(), params, "");
  for (const EstopTarget& target : targets) {
    print_of(target.name, "ordered");
    if (::fork() == 0) {
      ::_exit(run_program("tocsin estop", [&] { return give(target, params, target.name); }));
    }
  }
  int worst = 0;
  for (int status = 0; ::wait(&status) > 0 || errno == EINTR; status = 0) {
    worst = std::max(worst, WIFEXITED(status) ? WEXITSTATUS(status) : 1);
  }
  return worst;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Presses or releases the emergency stop of the vehicle. Without --run-dir and --vehicle, on "
      "and status are for every vehicle of every station that runs on this computer; off is for "
      "the only one, and refuses to choose among several",
      "tocsin estop");
  EstopOptions options;
  std::string order;
  Params params;
  params.direct = true;
  app.add_option("ORDER", order, "on, off or status")
      ->required()
      ->check(CLI::IsMember({"on", "off", "status"}));
  app.add_option("--wait", params.wait_s, "seconds to wait for the vehicle")
      ->check(CLI::Range(0.5, 600.0))
      ->capture_default_str();
  options.declare(app);
  return run_command(app, argc, argv, [&] {
    params.order = value_of<ConsoleOrder>("estop_" + order).value();
    // When it is not clear which vehicle is meant, all stand, and none drives.
    const Among among = order == "off" ? Among::only_one : Among::all;
    return give_all(find_targets(options, among, deployment::running_hosts()), params);
  });
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) { return tocsin::run(argc, argv); }
