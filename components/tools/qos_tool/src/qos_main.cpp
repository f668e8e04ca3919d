// SPDX-License-Identifier: Apache-2.0
// tocsin qos list | show | explain | diff | match | lint | export | import | set | tune.
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "qos_options.hpp"
#include "qos_verbs.hpp"

int main(int argc, char** argv) {
  tocsin::qos_tool::Options options;
  CLI::App app(
      "QoS profiles: what they mean, whether ends match, known traps, other vendors' files.");
  app.name("tocsin qos");
  tocsin::qos_tool::declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::qos_tool::run_verb(app.get_subcommands().front()->get_name(), options);
  });
}
