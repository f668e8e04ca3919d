// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/component_entry.hpp"

namespace tocsin {

/// Where a package registers its components, in the folder that it is installed to: a file with its
/// name and a line `name;library` for each, as rclcpp_components does. tocsin_component() of
/// tocsin_cmake writes it.
inline constexpr const char* component_index = "share/ament_index/resource_index/tocsin_components";

struct InstalledComponent {
  std::string name;
  std::string package;
  std::filesystem::path library;  ///< absolute
  std::filesystem::path prefix;   ///< that it was installed to
};

/// The variables that a workspace's setup.bash sets: folders, separated by ':'.
struct PrefixPaths {
  std::string colcon;  ///< $COLCON_PREFIX_PATH: install folders of workspaces
  std::string ament;   ///< $AMENT_PREFIX_PATH: of packages
  std::string cmake;   ///< $CMAKE_PREFIX_PATH: of packages
};

/// Those of this process.
[[nodiscard]] PrefixPaths prefix_paths();

/// The folders that packages with components are installed to, best first: those of `environment`
/// in its order, so that a workspace that was sourced later comes before. The install folder of
/// `program` (a file in its bin/) comes first of all unless the environment names it: who starts a
/// program by its path gets the components that belong to it.
[[nodiscard]] std::vector<std::filesystem::path> package_prefixes(
    const PrefixPaths& environment, const std::filesystem::path& program);

/// The components that are registered in `prefixes`, sorted by name; of two with one name the first
/// one's. Throws ConfigError, with file and line, when a line is not `name;library` or the library
/// would not be within its prefix.
[[nodiscard]] std::vector<InstalledComponent> components_in(
    const std::vector<std::filesystem::path>& prefixes);

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
