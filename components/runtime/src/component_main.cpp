// SPDX-License-Identifier: Apache-2.0
// tocsin component list | info NAME
#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "runtime/middleware/component_library.hpp"

namespace tocsin {
namespace {

int list() {
  for (const std::string& name : installed_components()) std::printf("%s\n", name.c_str());
  return 0;
}

int info(const std::string& name) {
  std::printf("%s:\n", name.c_str());
  const std::string defaults = load_component(name).defaults();
  for (std::size_t at = 0; at < defaults.size();) {
    const std::size_t end = defaults.find('\n', at);
    std::printf("  %s\n", defaults.substr(at, end - at).c_str());
    at = end + 1;
  }
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app("Lists the installed components; prints the parameters of one", "tocsin component");
  app.require_subcommand(1);
  const CLI::App* list_command = app.add_subcommand("list", "names of all installed components");
  CLI::App* info_command = app.add_subcommand("info", "parameters with default, unit and range");
  std::string name;
  info_command->add_option("NAME", name, "component")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw ConfigError(error.what());
  }
  return list_command->parsed() ? list() : info(name);
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin component", [&] { return tocsin::run(argc, argv); });
}
