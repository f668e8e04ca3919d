// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/role.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tocsin {

/// Adds `--host`, which names a side in every command: the host of a bringup file, for example uxv
/// or gcs, with or without a slash in front. The spellings of other tools are refused with a hint.
CLI::Option* add_host_option(CLI::App& app, std::string& host, const std::string& text);

/// The same where a side is told by its role only, uxv or gcs. Unchanged when it is not given.
CLI::Option* add_role_option(CLI::App& app, std::optional<Role>& role, const std::string& text);

/// Adds an option whose value is a name as ROS prints it: with or without a slash in front.
CLI::Option* add_name_option(CLI::App& app, const std::string& option, std::string& name,
                             const std::string& text);

}  // namespace tocsin
