// SPDX-License-Identifier: Apache-2.0
// tocsin teleop keyboard | gamepad
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "running_system.hpp"

int main(int argc, char** argv) {
  CLI::App app("Drives the vehicle by hand, with keys or a gamepad", "tocsin teleop");
  tocsin::JoinOptions join;
  std::string device;
  std::vector<std::string> settings;
  app.add_option("DEVICE", device, "keyboard or gamepad")
      ->required()
      ->check(CLI::IsMember({"keyboard", "gamepad"}));
  app.add_option("--set", settings, "parameter of the device: key=value")->expected(1)->take_all();
  join.declare(app);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::run_guest(join, {"teleop_" + device, settings});
  });
}
