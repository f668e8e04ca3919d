// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "runtime/component.hpp"
#include "runtime/middleware/component_layout.hpp"

namespace tocsin {

/// What a component's library tells about itself.
struct ComponentEntry {
  std::uint64_t layout;  ///< stays the first member: it is read before the rest is trusted
  /// Loads the parameters, then builds. Throws ConfigError, which points to the place in `sources`.
  std::unique_ptr<Component> (*create)(Context& context, const YAML::Node& parameters,
                                       const YamlSources& sources);
  /// Checks the parameters only. Throws ConfigError.
  void (*check)(const std::string& owner, const YAML::Node& parameters, const YamlSources& sources);
  /// All parameters with defaults, units and ranges, as commented YAML.
  std::string (*defaults)();
};

template <class T>
ComponentEntry make_component_entry() {
  return {component_layout(),
          [](Context& context, const YAML::Node& parameters,
             const YamlSources& sources) -> std::unique_ptr<Component> {
            const auto loaded =
                load_parameters<typename T::Params>(parameters, context.name, sources);
            try {
              return std::make_unique<T>(context, loaded);
            } catch (const ConfigError& error) {
              throw ConfigError(with_place(error.what(), parameters, sources));
            }
          },
          [](const std::string& owner, const YAML::Node& parameters, const YamlSources& sources) {
            (void)load_parameters<typename T::Params>(parameters, owner, sources);
          },
          [] { return default_yaml<typename T::Params>(); }};
}

}  // namespace tocsin

/// Makes a class loadable by its library's name: once, at the end of the component's .cpp file.
#define TOCSIN_COMPONENT(Class)                                                        \
  extern "C" const tocsin::ComponentEntry* tocsin_component() {                        \
    static const tocsin::ComponentEntry entry = tocsin::make_component_entry<Class>(); \
    return &entry;                                                                     \
  }
