// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "devices/computer.hpp"
#include "foundation/error.hpp"
#include "terminal_wait.hpp"
#include "verbs.hpp"

namespace {

using namespace tocsin::kobuki;
using tocsin::ConfigError;
using tocsin::EnvironmentError;

std::unique_ptr<tocsin::SerialDevice> open_port(const std::string& path) {
  auto opened = tocsin::this_computer().devices.try_open<tocsin::SerialDevice>(path);
  if (!opened.device) throw EnvironmentError(opened.reason);
  return std::move(opened.device);
}

int test_with(const std::string& port, const std::string& control, TerminalWait& wait) {
  if (control.empty() && !wait.has_keys()) {
    throw ConfigError("test: a person must answer in a terminal; without one, use --auto");
  }
  std::unique_ptr<ControlClient> client;
  if (!control.empty()) client = std::make_unique<ControlClient>(control);
  if (client && !client->ask("get")) throw EnvironmentError(control + ": no simulator answers");
  Session session(open_port(port), port, wait);
  return test(session, client.get());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Looks at a Kobuki base on its port: versions, live sensors, acceptance test",
               "tocsin kobuki");
  app.require_subcommand(1);
  app.fallthrough();
  std::string port = "/dev/kobuki";
  std::string control;
  app.add_option("--port", port, "serial device; nobody else may use it")->capture_default_str();
  app.add_subcommand("info", "versions, id, battery, gains");
  CLI::App* watch_verb = app.add_subcommand("watch", "live sensors; q ends");
  CLI::App* test_verb = app.add_subcommand(
      "test", "acceptance list: LEDs, sounds, buttons, bumpers, cliffs, wheels, gyro, square");
  test_verb->add_option("--auto", control, "control socket of kobuki_simulator, in place of hands");
  return tocsin::run_command(app, argc, argv, [&] {
    TerminalWait wait;
    if (test_verb->parsed()) return test_with(port, control, wait);
    Session session(open_port(port), port, wait);
    return watch_verb->parsed() ? watch(session, ::isatty(STDOUT_FILENO) == 1) : info(session);
  });
}
