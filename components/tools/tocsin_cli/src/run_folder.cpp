// SPDX-License-Identifier: Apache-2.0
#include "run_folder.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "foundation/replace_file.hpp"

namespace tocsin::cli {
namespace fs = std::filesystem;

std::error_code write_pids(const fs::path& folder, const std::map<std::string, int>& pids) {
  // Nobody needs it after a loss of power.
  return replace_file(folder / "processes.json", nlohmann::json(pids).dump(2) + "\n", Sync::no);
}

void sweep(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const bool dangling = entry.is_symlink() && !fs::exists(entry.path(), ignored);
    if (entry.is_socket(ignored) || dangling) left.push_back(entry.path());
  }
  for (const fs::path& path : left) fs::remove(path, ignored);
}

}  // namespace tocsin::cli
