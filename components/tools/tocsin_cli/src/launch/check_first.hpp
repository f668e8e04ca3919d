// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "command_line/bringup_options.hpp"

namespace tocsin::cli {

/// Runs `tocsin check`, which is `program`, on what is to be launched; what is wrong is printed on
/// stderr. False when it refuses.
[[nodiscard]] bool check_first(const BringupOptions& options, const std::filesystem::path& program);

}  // namespace tocsin::cli
