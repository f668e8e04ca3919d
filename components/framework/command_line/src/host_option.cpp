// SPDX-License-Identifier: Apache-2.0
#include "command_line/host_option.hpp"

#include <CLI/CLI.hpp>

#include "foundation/names.hpp"

namespace tocsin {

CLI::Option* add_name_option(CLI::App& app, const std::string& option, std::string& name,
                             const std::string& text) {
  const auto strip = [](std::string& given) {
    given = without_slash(std::move(given));
    return std::string();
  };
  return app.add_option(option, name, text)->transform(CLI::Validator(strip, ""));
}

CLI::Option* add_host_option(CLI::App& app, std::string& host, const std::string& text) {
  for (const char* other : {"--on", "--role", "--side"}) {
    app.add_option_function<std::string>(other,
                                         [other](const std::string& side) {
                                           throw CLI::ValidationError(
                                               other, "the side is named by --host " + side);
                                         })
        ->group("");  // not in the help
  }
  return add_name_option(app, "--host", host, text);
}

}  // namespace tocsin
