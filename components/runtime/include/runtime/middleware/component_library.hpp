// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/component_entry.hpp"

namespace tocsin {

/// The entry of the component library lib<name>.so, searched beside the running program: in
/// ../lib/tocsin (one install folder for all) and in ../../<name>/lib/tocsin (one per package).
/// The library stays loaded for the life of the process. Throws ConfigError naming the component
/// when there is none, or when it is not a component.
[[nodiscard]] const ComponentEntry& load_component(const std::string& name);

/// The same for the library `file`. Throws ConfigError, too, when it was built with other headers.
[[nodiscard]] const ComponentEntry& open_component(const std::string& name,
                                                   const std::filesystem::path& file);

/// Names of the component libraries that load_component would find, sorted.
[[nodiscard]] std::vector<std::string> installed_components();

}  // namespace tocsin
