// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "qos_options.hpp"

namespace tocsin::qos_tool {

/// The exit code of `verb`. Throws ConfigError and EnvironmentError.
[[nodiscard]] int run_verb(const std::string& verb, const Options& options);

}  // namespace tocsin::qos_tool
