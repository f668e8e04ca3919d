// SPDX-License-Identifier: Apache-2.0
// tocsin bag record | play | info | recover | filter | merge | convert | export, as `ros2 bag` has
// them.
#include <CLI/CLI.hpp>

#include "bag_options.hpp"
#include "bag_verbs.hpp"
#include "command_line/command.hpp"

int main(int argc, char** argv) {
  tocsin::bag_tool::Options options;
  CLI::App app("Bags: recordings of topics that ros2 bag, Foxglove and Lichtblick open, too.");
  app.name("tocsin bag");
  tocsin::bag_tool::declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::bag_tool::run_verb(app.get_subcommands().front()->get_name(), options);
  });
}
