// SPDX-License-Identifier: Apache-2.0
// tocsin topic list | info | echo | hz | bw | delay | pub | find | type, as `ros2 topic` has them.
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "topic_options.hpp"
#include "topic_verbs.hpp"

int main(int argc, char** argv) {
  tocsin::topic_tool::Options options;
  CLI::App app("Topics of a running host, ours and those of other DDS and ROS 2 programs there.");
  app.name("tocsin topic");
  tocsin::topic_tool::declare(app, options);
  return tocsin::run_command(app, argc, argv, [&] {
    return tocsin::topic_tool::run_verb(app.get_subcommands().front()->get_name(), options);
  });
}
