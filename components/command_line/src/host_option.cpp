// SPDX-License-Identifier: Apache-2.0
#include "command_line/host_option.hpp"

#include <CLI/CLI.hpp>

#include "foundation/names.hpp"

namespace tocsin {

CLI::Option* add_host_option(CLI::App& app, std::string& host, const std::string& text) {
  for (const char* other : {"--on", "--role", "--side"}) {
    app.add_option_function<std::string>(other,
                                         [other](const std::string& side) {
                                           throw CLI::ValidationError(
                                               other, "the side is named by --host " + side);
                                         })
        ->group("");  // not in the help
  }
  const auto strip = [](std::string& name) {
    name = without_slash(std::move(name));
    return std::string();
  };
  return app.add_option("--host", host, text)->transform(CLI::Validator(strip, ""));
}

}  // namespace tocsin
