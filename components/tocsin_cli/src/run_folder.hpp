// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace tocsin::cli {

/// Makes the folder of a run and returns its absolute path. An empty `wanted` means
/// `runs/<UTC time>` under the working folder. Throws EnvironmentError.
[[nodiscard]] std::filesystem::path make_run_folder(const std::string& wanted);

/// Writes `processes.json`, name to pid, in one step, so that a reader never sees half of it.
void write_pids(const std::filesystem::path& folder, const std::map<std::string, int>& pids);

/// Removes sockets and dangling links that killed processes have left in the folder.
void sweep(const std::filesystem::path& folder);

}  // namespace tocsin::cli
