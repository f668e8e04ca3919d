// SPDX-License-Identifier: Apache-2.0
#include "command_line/command.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "command_line/option_checks.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"

namespace tocsin {

int run_command(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  return run_program(app.get_name(), [&] {
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& help) {
      return app.exit(help);
    } catch (const CLI::ParseError& error) {
      throw ConfigError(usage_error(app, error));
    }
    return body();
  });
}

Verbs::Verbs(CLI::App& app) : app_(app) { app_.require_subcommand(1); }

CLI::App* Verbs::add(const std::string& name, const std::string& text, std::function<int()> body) {
  CLI::App* const verb = app_.add_subcommand(name, text);
  bodies_[verb] = std::move(body);
  return verb;
}

int Verbs::run(int argc, char** argv) const {
  return run_command(app_, argc, argv,
                     [&] { return bodies_.at(app_.get_subcommands().front())(); });
}

}  // namespace tocsin
