// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "foundation/error.hpp"
#include "options.hpp"
#include "script.hpp"
#include "simulator.hpp"

int main(int argc, char** argv) {
  using tocsin::kobuki::make_model;
  using tocsin::kobuki::Simulator;
  try {
    int exit_code = 0;
    const auto options = tocsin::kobuki::parse_options(argc, argv, exit_code);
    if (!options) return exit_code;
    if (options->check) {
      const tocsin::Time now{};
      (void)make_model(*options, make_room(*options), now);
      (void)tocsin::kobuki::Script(options->script, options->script_file, now);
      return 0;
    }
    Simulator simulator(*options);
    simulator.run();
    return 0;
  } catch (const tocsin::ConfigError& error) {
    std::fprintf(stderr, "kobuki_simulator: %s\n", error.what());
    return 2;
  } catch (const tocsin::EnvironmentError& error) {
    std::fprintf(stderr, "kobuki_simulator: %s\n", error.what());
    return 1;
  }
}
