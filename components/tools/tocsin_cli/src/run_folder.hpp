// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <system_error>

namespace tocsin::cli {

/// Writes `processes.json`, name to pid, in one step: a reader never sees half of it, and on a full
/// disk the list before stays. Returns why it could not be written.
[[nodiscard]] std::error_code write_pids(const std::filesystem::path& folder,
                                         const std::map<std::string, int>& pids);

/// Removes sockets and dangling links that killed processes have left in the folder.
void sweep(const std::filesystem::path& folder);

}  // namespace tocsin::cli
