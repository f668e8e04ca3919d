// SPDX-License-Identifier: Apache-2.0
// tocsin estop on | off | status
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "running_system.hpp"

int main(int argc, char** argv) {
  CLI::App app("Presses or releases the emergency stop of the vehicle", "tocsin estop");
  tocsin::JoinOptions join;
  std::string order;
  double wait_s = 5;
  app.add_option("ORDER", order, "on, off or status")
      ->required()
      ->check(CLI::IsMember({"on", "off", "status"}));
  app.add_option("--wait", wait_s, "seconds to wait for the vehicle")->capture_default_str();
  join.declare(app);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::run_guest(
        join, {"operator_console", {"order=estop_" + order, "wait_s=" + std::to_string(wait_s)}});
  });
}
