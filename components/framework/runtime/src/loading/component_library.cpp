// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include <map>
#include <mutex>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/ownership.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

fs::path library_of(const std::string& name) {
  if (!is_name(name)) {
    throw ConfigError("component '" + printable(name) + "': is not a name (" + name_rule + ")");
  }
  for (InstalledComponent& component : installed_components()) {
    if (component.name != name) continue;
    if (const auto reason = changeable_by_others_below(component.prefix, component.library)) {
      throw ConfigError("component '" + name + "': " + *reason +
                        "; what is loaded must belong to this user or root, and nobody else may "
                        "write there");
    }
    return std::move(component.library);
  }
  throw ConfigError("component '" + name +
                    "': no installed package has one of this name; see tocsin component types, and "
                    "source the setup.bash of the workspace that has it" +
                    suggestion(installed_component_names(), name));
}

}  // namespace

std::vector<InstalledComponent> installed_components() {
  return components_in(package_prefixes(prefix_paths(), own_program()));
}

std::vector<std::string> installed_component_names() {
  std::vector<std::string> names;
  for (const InstalledComponent& one : installed_components()) names.push_back(one.name);
  return names;
}

const ComponentEntry& load_component(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, const ComponentEntry*> loaded;
  const std::lock_guard<std::mutex> lock(mutex);
  const ComponentEntry*& entry = loaded[name];
  if (entry == nullptr) entry = &open_component(name, library_of(name));
  return *entry;
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
