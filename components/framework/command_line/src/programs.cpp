// SPDX-License-Identifier: Apache-2.0
#include "command_line/programs.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

namespace tocsin {
namespace fs = std::filesystem;
namespace {

bool is_executable(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code unreadable;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

fs::path own_program() {
  std::error_code unreadable;
  return fs::read_symlink("/proc/self/exe", unreadable);
}

Folders program_folders(const fs::path& program, const std::string& path_variable) {
  Folders folders{program.parent_path()};
  if (program.parent_path().filename() == "bin") {
    for (const fs::path& package : entries(program.parent_path().parent_path().parent_path())) {
      std::error_code ignored;
      if (fs::is_directory(package / "bin", ignored)) folders.push_back(package / "bin");
    }
  }
  std::istringstream path(path_variable);
  for (std::string folder; std::getline(path, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

Folders program_folders() {
  const char* path = std::getenv("PATH");
  return program_folders(own_program(), path == nullptr ? "" : path);
}

std::optional<fs::path> find_program(const std::string& name, const Folders& folders) {
  if (name.find('/') != std::string::npos) {
    return is_executable(name) ? std::optional<fs::path>(name) : std::nullopt;
  }
  for (const fs::path& folder : folders) {
    if (is_executable(folder / name)) return folder / name;
  }
  return std::nullopt;
}

std::vector<std::string> find_verbs(const Folders& folders) {
  const std::string prefix = "tocsin-";
  std::set<std::string> verbs;
  for (const fs::path& folder : folders) {
    for (const fs::path& file : entries(folder)) {
      const std::string name = file.filename().string();
      if (name.rfind(prefix, 0) == 0 && is_executable(file)) {
        verbs.insert(name.substr(prefix.size()));
      }
    }
  }
  return {verbs.begin(), verbs.end()};
}

fs::path share_folder(const fs::path& program) {
  const fs::path prefix = program.parent_path().parent_path();
  const fs::path isolated = prefix.parent_path() / "bringup/share/tocsin";
  std::error_code ignored;
  if (!fs::is_directory(prefix / "share/tocsin", ignored) && fs::is_directory(isolated, ignored)) {
    return isolated;
  }
  return prefix / "share/tocsin";
}

}  // namespace tocsin
