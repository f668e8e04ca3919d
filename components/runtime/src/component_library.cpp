// SPDX-License-Identifier: Apache-2.0
#include "component_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <vector>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

std::vector<std::filesystem::path> candidates(const std::string& name) {
  const std::filesystem::path bin = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::filesystem::path file = "lib/tocsin/lib" + name + ".so";
  return {bin / ".." / file, bin / "../.." / name / file};
}

std::filesystem::path find(const std::string& name) {
  for (const auto& path : candidates(name)) {
    if (std::filesystem::exists(path)) return path;
  }
  throw ConfigError("component '" + name + "': no library lib" + name +
                    ".so is installed (searched " + candidates(name)[0].string() + " and " +
                    candidates(name)[1].string() + ")");
}

}  // namespace

const ComponentEntry& load_component(const std::string& name) {
  void* library = dlopen(find(name).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw ConfigError("component '" + name + "': " + dlerror());
  using EntryFunction = const ComponentEntry* (*)();
  const auto entry = reinterpret_cast<EntryFunction>(dlsym(library, "tocsin_component"));
  if (entry == nullptr) throw ConfigError("component '" + name + "': " + dlerror());
  return *entry();
}

}  // namespace tocsin
