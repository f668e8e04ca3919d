// SPDX-License-Identifier: Apache-2.0
// One program under seven names: tocsin-topic, tocsin-node, ... as `tocsin topic` and the like call
// it.
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "commands.hpp"

namespace {

using namespace tocsin::topic_tool;

constexpr std::array<std::pair<std::string_view, int (*)(int, char**)>, 7> commands{
    {{"action", run_action},
     {"interface", run_interface},
     {"lifecycle", run_lifecycle},
     {"node", run_node},
     {"param", run_param},
     {"service", run_service},
     {"topic", run_topic}}};

/// `topic` of `topic` and of `/opt/tocsin/bin/tocsin-topic`.
std::string_view command_in(std::string_view name) {
  const auto slash = name.rfind('/');
  if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
  const std::string_view prefix = "tocsin-";
  if (name.substr(0, prefix.size()) == prefix) name.remove_prefix(prefix.size());
  return name;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view wanted = command_in(argc > 0 ? argv[0] : "");
  for (const auto& [name, run] : commands) {
    if (name == wanted) return run(argc, argv);
  }
  std::fputs("tocsin-topic: is called by one of its names, see tocsin --help\n", stderr);
  return 2;
}
