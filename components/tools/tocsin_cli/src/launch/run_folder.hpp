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

/// Gives root's empty folder to this process's user; what is not there, not empty or another's
/// stays as it is. Needs CAP_CHOWN. A path with symbolic links is refused with ConfigError, since
/// whoever made them could have any folder given to him.
void give_empty_folder(const std::filesystem::path& folder);

/// Removes sockets and dangling links that killed processes have left in the folder.
void sweep(const std::filesystem::path& folder);

}  // namespace tocsin::cli
