// SPDX-License-Identifier: Apache-2.0
#include "folder.hpp"

#include <algorithm>
#include <filesystem>

#include "foundation/error.hpp"

namespace tocsin::bag {

namespace fs = std::filesystem;

std::string without_slash_behind(const std::string& folder) {
  return (fs::path(folder) / "").parent_path();
}

void make_folder(const std::string& folder) {
  std::error_code failed;
  const fs::path parent = fs::path(without_slash_behind(folder)).parent_path();
  if (!parent.empty()) fs::create_directories(parent, failed);
  const bool made = !failed && fs::create_directory(folder, failed);
  if (failed) throw ConfigError(folder + ": cannot be made: " + failed.message());
  if (!made) throw ConfigError(folder + ": is there already; a bag needs a new folder");
}

std::vector<std::string> mcap_files_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".mcap") names.push_back(file.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace tocsin::bag
