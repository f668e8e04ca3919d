// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/idl_libraries.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "command_line/programs.hpp"
#include "foundation/ownership.hpp"
#include "loading/sorted_entries.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

/// An install folder of all packages, or one with a folder for each.
void add_workspace(const fs::path& install, std::vector<fs::path>& prefixes) {
  prefixes.push_back(install);
  for (const fs::path& package : sorted_entries(install)) prefixes.push_back(package);
}

std::vector<fs::path> installed_prefixes() {
  const fs::path own = own_program().parent_path().parent_path();
  std::vector<fs::path> prefixes{own};
  add_workspace(own.parent_path(), prefixes);
  for (const char* variable : {"COLCON_PREFIX_PATH", "AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"}) {
    const char* const value = std::getenv(variable);
    std::istringstream folders(value == nullptr ? "" : value);
    for (std::string folder; std::getline(folders, folder, ':');) {
      if (!folder.empty()) add_workspace(folder, prefixes);
    }
  }
  return prefixes;
}

}  // namespace

std::vector<fs::path> idl_libraries_in(const std::vector<fs::path>& prefixes) {
  std::vector<fs::path> libraries;
  std::error_code ignored;
  for (const fs::path& prefix : prefixes) {
    for (const fs::path& package : sorted_entries(prefix / "share")) {
      const fs::path library = prefix / "lib" / ("lib" + package.filename().string() + ".so");
      if (!fs::is_directory(package / "idl", ignored) || !fs::exists(library, ignored)) continue;
      if (changeable_by_others_below(prefix, library)) continue;
      const bool known = std::find(libraries.begin(), libraries.end(), library) != libraries.end();
      if (!known) libraries.push_back(library);
    }
  }
  return libraries;
}

void load_idl_libraries() {
  static const bool loaded = [] {
    for (const fs::path& library : idl_libraries_in(installed_prefixes())) {
      (void)::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    }
    return true;
  }();
  (void)loaded;
}

}  // namespace tocsin
