// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::bag {

/// The same folder without a slash behind its name.
[[nodiscard]] std::string without_slash_behind(const std::string& folder);

/// Makes a new folder and those above it. Throws ConfigError when it is there already or cannot be
/// made.
void make_folder(const std::string& folder);

/// The names of all MCAP files in a folder, in their order.
[[nodiscard]] std::vector<std::string> mcap_files_in(const std::string& folder);

}  // namespace tocsin::bag
