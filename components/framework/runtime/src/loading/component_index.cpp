// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/read_file.hpp"
#include "loading/sorted_entries.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_index = 65536;  // [byte]

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::vector<fs::path> folders_of(const std::string& variable) {
  std::vector<fs::path> folders;
  std::istringstream words(variable);
  for (std::string word; std::getline(words, word, ':');) {
    if (!word.empty()) folders.push_back(fs::path(word).lexically_normal());
  }
  return folders;
}

/// The prefixes of packages, each once, those without components left out.
class Prefixes {
 public:
  void add_package(const fs::path& prefix) {
    std::error_code ignored;
    const bool is_new = std::find(all_.begin(), all_.end(), prefix) == all_.end();
    if (is_new && fs::is_directory(prefix / component_index, ignored)) all_.push_back(prefix);
  }
  /// One folder for all packages, or one with a folder for each.
  void add_workspace(const fs::path& install) {
    add_package(install);
    for (const fs::path& package : sorted_entries(install)) add_package(package);
  }
  [[nodiscard]] std::vector<fs::path> take() { return std::move(all_); }

 private:
  std::vector<fs::path> all_;
};

/// The install folder of the workspace of a program, of which colcon tells whether it has a folder
/// for each package.
fs::path workspace_of(const fs::path& program) {
  const fs::path prefix = program.parent_path().parent_path();
  std::string layout;
  std::ifstream(prefix.parent_path() / ".colcon_install_layout") >> layout;
  return layout == "isolated" ? prefix.parent_path() : prefix;
}

InstalledComponent read_line(const std::string& line, const fs::path& prefix, const fs::path& index,
                             int number) {
  const std::size_t end = line.find(';');
  const std::string name = line.substr(0, end);
  const fs::path library = end == std::string::npos ? "" : line.substr(end + 1);
  const fs::path inside = library.lexically_normal();
  if (!is_name(name) || inside.empty() || inside.is_absolute() || *inside.begin() == "..") {
    throw ConfigError(index.string() + ":" + std::to_string(number) + ": '" + line +
                      "' is not name;library, with the path of a library below " + prefix.string());
  }
  return {name, index.filename().string(), prefix / inside, prefix};
}

}  // namespace

PrefixPaths prefix_paths() {
  return {variable("COLCON_PREFIX_PATH"), variable("AMENT_PREFIX_PATH"),
          variable("CMAKE_PREFIX_PATH")};
}

std::vector<fs::path> package_prefixes(const PrefixPaths& environment, const fs::path& program) {
  const auto workspaces = folders_of(environment.colcon);
  const fs::path own = workspace_of(program);
  Prefixes prefixes;
  if (std::find(workspaces.begin(), workspaces.end(), own) == workspaces.end()) {
    prefixes.add_workspace(own);
  }
  for (const fs::path& workspace : workspaces) prefixes.add_workspace(workspace);
  for (const fs::path& package : folders_of(environment.ament)) prefixes.add_package(package);
  for (const fs::path& package : folders_of(environment.cmake)) prefixes.add_package(package);
  return prefixes.take();
}

std::vector<InstalledComponent> components_in(const std::vector<fs::path>& prefixes) {
  std::map<std::string, InstalledComponent> found;
  for (const fs::path& prefix : prefixes) {
    for (const fs::path& index : sorted_entries(prefix / component_index)) {
      std::istringstream lines(read_file(index.string(), longest_index));
      int number = 0;
      for (std::string line; std::getline(lines, line);) {
        InstalledComponent component = read_line(line, prefix, index, ++number);
        found.emplace(component.name, std::move(component));
      }
    }
  }
  std::vector<InstalledComponent> components;
  for (auto& entry : found) components.push_back(std::move(entry.second));
  return components;
}

}  // namespace tocsin
