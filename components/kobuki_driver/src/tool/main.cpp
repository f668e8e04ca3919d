// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "acceptance.hpp"
#include "command_line/command.hpp"
#include "foundation/error.hpp"
#include "pages.hpp"
#include "session.hpp"

namespace {

using namespace tocsin::kobuki;
using tocsin::EnvironmentError;

void wait_for_base(Session& session, const std::string& port) {
  const bool heard =
      session.run_until([&] { return session.last() != nullptr; }, std::chrono::seconds(3));
  if (!heard) throw EnvironmentError(port + ": no base is sending there");
}

int info(const std::string& port) {
  Session session(port);
  wait_for_base(session, port);
  const Inquiry& known = session.driver().inquiry();
  (void)session.run_until(
      [&] {
        const bool versions = known.hardware() && known.firmware() && known.unique_id();
        return versions && (known.gains() || !has_gains(*known.firmware()));
      },
      std::chrono::seconds(2));
  std::fputs(info_page(session.driver(), *session.last()).c_str(), stdout);
  return 0;
}

int watch(const std::string& port) {
  Session session(port);
  wait_for_base(session, port);
  const bool screen = ::isatty(STDOUT_FILENO) == 1;
  while (!session.over() && session.key() != 'q') {
    std::fputs(screen ? "\x1b[H\x1b[2J" : "", stdout);
    std::fputs(watch_page(session.driver(), *session.last()).c_str(), stdout);
    std::puts(screen ? "q ends" : "");
    std::fflush(stdout);
    session.run_for(std::chrono::milliseconds(200));
  }
  return 0;
}

int test(const std::string& port, const std::string& control) {
  std::unique_ptr<ControlClient> client;
  if (!control.empty()) client = std::make_unique<ControlClient>(control);
  if (client && !client->ask("get")) throw EnvironmentError(control + ": no simulator answers");
  Session session(port);
  wait_for_base(session, port);
  return Acceptance(session, client.get()).run() == 0 ? 0 : 1;
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
  CLI::App* info_verb = app.add_subcommand("info", "versions, id, battery, gains");
  CLI::App* watch_verb = app.add_subcommand("watch", "live sensors; q ends");
  CLI::App* test_verb = app.add_subcommand(
      "test", "acceptance list: LEDs, sounds, buttons, bumpers, cliffs, wheels, gyro, square");
  test_verb->add_option("--auto", control, "control socket of kobuki_simulator, in place of hands");
  return tocsin::run_command(app, argc, argv, [&] {
    if (info_verb->parsed()) return info(port);
    if (watch_verb->parsed()) return watch(port);
    return test(port, control);
  });
}
