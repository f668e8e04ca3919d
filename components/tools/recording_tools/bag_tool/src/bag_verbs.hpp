// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "bag_options.hpp"

namespace tocsin::bag_tool {

/// Does what a verb says and returns the exit code: 1 when messages were lost. Throws ConfigError
/// for what a person said wrong, EnvironmentError for what is not there.
[[nodiscard]] int run_verb(const std::string& verb, Options options);

}  // namespace tocsin::bag_tool
