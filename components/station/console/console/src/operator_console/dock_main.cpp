// SPDX-License-Identifier: Apache-2.0
// tocsin dock start | cancel | status
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "running_system.hpp"

int main(int argc, char** argv) {
  CLI::App app("Drives the vehicle into its charging dock", "tocsin dock");
  tocsin::JoinOptions join;
  std::string order = "start";
  double wait_s = 10;
  app.add_option("ORDER", order, "start, cancel or status")
      ->check(CLI::IsMember({"start", "cancel", "status"}))
      ->capture_default_str();
  app.add_option("--wait", wait_s, "longest silence of the vehicle, seconds")
      ->capture_default_str();
  join.declare(app);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::run_guest(
        join, {"operator_console", {"order=dock_" + order, "wait_s=" + std::to_string(wait_s)}});
  });
}
