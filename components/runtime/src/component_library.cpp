// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include <set>
#include <vector>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

fs::path bin_folder() { return own_program().parent_path(); }

std::vector<fs::path> candidates(const std::string& name) {
  const fs::path bin = bin_folder();
  const fs::path file = "lib/tocsin/lib" + name + ".so";
  return {bin / ".." / file, bin / "../.." / name / file};
}

fs::path find(const std::string& name) {
  for (const auto& path : candidates(name)) {
    if (fs::exists(path)) return path;
  }
  throw ConfigError("component '" + name + "': no library lib" + name +
                    ".so is installed (searched " + candidates(name)[0].string() + " and " +
                    candidates(name)[1].string() + ")");
}

/// Adds the names of lib<name>.so in `folder`.
void add_components(const fs::path& folder, std::set<std::string>& names) {
  std::error_code absent;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, absent)) {
    const std::string stem = file.path().stem();
    if (file.path().extension() == ".so" && stem.rfind("lib", 0) == 0) names.insert(stem.substr(3));
  }
}

}  // namespace

std::vector<std::string> installed_components() {
  std::set<std::string> names;
  add_components(bin_folder() / "../lib/tocsin", names);
  std::error_code absent;
  for (const fs::directory_entry& package :
       fs::directory_iterator(bin_folder() / "../..", absent)) {
    add_components(package.path() / "lib/tocsin", names);
  }
  return {names.begin(), names.end()};
}

const ComponentEntry& load_component(const std::string& name) {
  return open_component(name, find(name));
}

const ComponentEntry& open_component(const std::string& name, const fs::path& file) {
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw ConfigError("component '" + name + "': " + dlerror());
  using EntryFunction = const ComponentEntry* (*)();
  const auto entry = reinterpret_cast<EntryFunction>(dlsym(library, "tocsin_component"));
  if (entry == nullptr) throw ConfigError("component '" + name + "': " + dlerror());
  if (const std::uint64_t layout = entry()->layout; layout != component_layout()) {
    throw ConfigError(
        fmt::format("component '{}': {} was built with other headers: layout {:x}, must be {:x}; "
                    "build it again",
                    name, file.string(), layout, component_layout()));
  }
  return *entry();
}

}  // namespace tocsin
