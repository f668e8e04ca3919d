// SPDX-License-Identifier: Apache-2.0
// tocsin qos list | show | explain | diff | match | lint | export | set | tune.
#include <CLI/CLI.hpp>

#include "command_line/command.hpp"
#include "qos_options.hpp"

int main(int argc, char** argv) {
  CLI::App app(
      "QoS profiles: what they mean, whether ends match, known traps, other vendors' files.",
      "tocsin qos");
  tocsin::qos_tool::Options options;
  tocsin::Verbs verbs(app);
  tocsin::qos_tool::declare(verbs, options);
  return verbs.run(argc, argv);
}
