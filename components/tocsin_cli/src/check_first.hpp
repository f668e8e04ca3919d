// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "command_line/bringup_options.hpp"
#include "command_line/programs.hpp"

namespace tocsin::cli {

/// Runs `tocsin check` on what is to be launched; it prints what is wrong on stderr. False when it
/// refuses. Throws ConfigError when the program is in none of `folders`.
[[nodiscard]] bool check_first(const BringupOptions& options, const Folders& folders);

}  // namespace tocsin::cli
