// SPDX-License-Identifier: Apache-2.0
#include "run_folder.hpp"

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin::cli {
namespace fs = std::filesystem;

fs::path make_run_folder(const std::string& wanted) {
  fs::path folder = wanted;
  if (wanted.empty()) {
    char stamp[32];
    const std::time_t now = std::time(nullptr);
    std::strftime(stamp, sizeof stamp, "%Y%m%dT%H%M%SZ", std::gmtime(&now));
    folder = fs::path("runs") / stamp;
  }
  std::error_code error;
  folder = fs::absolute(folder).lexically_normal();
  fs::create_directories(folder, error);
  if (error) throw EnvironmentError(folder.string() + ": cannot be made: " + error.message());
  return folder;
}

void write_pids(const fs::path& folder, const std::map<std::string, int>& pids) {
  const fs::path next = folder / "processes.json.next";
  std::ofstream(next) << nlohmann::json(pids).dump(2) << "\n";
  std::error_code ignored;  // a full disk must not end the run
  fs::rename(next, folder / "processes.json", ignored);
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
