// SPDX-License-Identifier: Apache-2.0
#include "command_line/host_option.hpp"

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "foundation/names.hpp"

namespace tocsin {
namespace {

/// Takes the slash away with which ROS prints a name.
CLI::Validator without_slash_in_front() {
  const auto strip = [](std::string& given) {
    given = without_slash(std::move(given));
    return std::string();
  };
  return {strip, ""};
}

void refuse_other_spellings(CLI::App& app) {
  for (const char* other : {"--on", "--role", "--side"}) {
    app.add_option_function<std::string>(other,
                                         [other](const std::string& side) {
                                           throw CLI::ValidationError(
                                               other, "the side is named by --host " + side);
                                         })
        ->group("");  // not in the help
  }
}

}  // namespace

CLI::Option* add_name_option(CLI::App& app, const std::string& option, std::string& name,
                             const std::string& text) {
  return app.add_option(option, name, text)->transform(without_slash_in_front());
}

CLI::Option* add_host_option(CLI::App& app, std::string& host, const std::string& text) {
  refuse_other_spellings(app);
  return add_name_option(app, "--host", host, text);
}

CLI::Option* add_role_option(CLI::App& app, std::optional<Role>& role, const std::string& text) {
  refuse_other_spellings(app);
  std::vector<std::string> words;
  for (const Role one : roles) words.emplace_back(to_string(one));
  const auto take = [&role](const std::string& word) { role = role_of(word); };
  return app.add_option_function<std::string>("--host", take, text)
      ->transform(without_slash_in_front())
      ->check(CLI::IsMember(words));
}

}  // namespace tocsin
