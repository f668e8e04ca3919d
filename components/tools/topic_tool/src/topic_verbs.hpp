// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "topic_options.hpp"

namespace tocsin::topic_tool {

/// Does what a verb says and returns the exit code. Throws ConfigError for what a person said
/// wrong, EnvironmentError for what is not there.
[[nodiscard]] int run_verb(const std::string& verb, const Options& options);

}  // namespace tocsin::topic_tool
