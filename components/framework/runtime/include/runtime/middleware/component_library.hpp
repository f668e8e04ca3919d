// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/component_entry.hpp"
#include "runtime/middleware/component_index.hpp"

namespace tocsin {

/// The entry of a component that is installed. Its library stays loaded for the life of the
/// process. Throws ConfigError naming the component when `name` is no name (so that no path gets
/// here), when no package has registered it, when others than this user and root may
/// change its library, or when that is not a component. Any thread.
[[nodiscard]] const ComponentEntry& load_component(const std::string& name);

/// The same for the library `file`. Throws ConfigError, too, when it was built with other headers.
[[nodiscard]] const ComponentEntry& open_component(const std::string& name,
                                                   const std::filesystem::path& file);

/// The components that load_component finds, sorted by name. Throws ConfigError when an index is
/// damaged.
[[nodiscard]] std::vector<InstalledComponent> installed_components();
/// Their names only.
[[nodiscard]] std::vector<std::string> installed_component_names();

}  // namespace tocsin
