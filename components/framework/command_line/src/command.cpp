// SPDX-License-Identifier: Apache-2.0
#include "command_line/command.hpp"

#include <CLI/CLI.hpp>

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

}  // namespace tocsin
