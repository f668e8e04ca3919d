// SPDX-License-Identifier: Apache-2.0
// tocsin keystore create | add | permit | revoke | list | check: who may speak on a secured link.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <ctime>

#include "command_line/command.hpp"
#include "command_line/programs.hpp"
#include "verbs.hpp"

int main(int argc, char** argv) {
  using namespace tocsin;
  keystore_tool::Options options;
  CLI::App app("Identities and permissions of a secured link (DDS Security, laid out as SROS2's).");
  app.name("tocsin keystore");
  keystore_tool::declare(app, options);
  return run_command(app, argc, argv, [&] {
    if (options.traffic_file.empty()) {
      options.traffic_file = share_folder(own_program()) / "config/traffic.yaml";
    }
    const auto answer = keystore_tool::run_verb(app.get_subcommands().front()->get_name(), options,
                                                std::time(nullptr));
    std::fputs(answer.text.c_str(), stdout);
    return answer.code;
  });
}
