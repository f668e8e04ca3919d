// SPDX-License-Identifier: Apache-2.0
// What a component's library tells about itself, and how that is made of its class.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/parameter_facts.hpp"
#include "foundation/parameters.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Differs when a library and the runtime were compiled with different headers: the sizes of what
/// they share, and a number in front that is raised by hand when only a virtual function changes.
constexpr std::uint64_t component_layout() {
  std::uint64_t layout = 3;
  for (const std::size_t size :
       {sizeof(Component), sizeof(InputPort), sizeof(Schedule), sizeof(Context), sizeof(Sample),
        sizeof(TypeInfo), sizeof(SampleQueue), sizeof(PortHealth)}) {
    layout = layout * 1000003U + size;
  }
  return layout;
}

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
  /// All parameters as these give them. Throws ConfigError.
  std::vector<ParameterFacts> (*facts)(const std::string& owner, const YAML::Node& parameters,
                                       const YamlSources& sources);
  /// Hands these to a component that runs, from its next tick on, once all are checked. Throws
  /// ConfigError, and the component keeps what it has.
  void (*change)(Component& component, const YAML::Node& parameters, const YamlSources& sources);
};

/// Whether T takes other values for its live parameters: `void set_parameters(const Params&)`.
template <class T, class = void>
struct TakesParameters : std::false_type {};
template <class T>
struct TakesParameters<T, std::void_t<decltype(std::declval<T&>().set_parameters(
                              std::declval<const typename T::Params&>()))>> : std::true_type {};

/// Whether T has rules across parameters: `static void check(const Params&)`, which throws
/// ConfigError.
template <class T, class = void>
struct HasRules : std::false_type {};
template <class T>
struct HasRules<T, std::void_t<decltype(T::check(std::declval<const typename T::Params&>()))>>
    : std::true_type {};

/// Throws ConfigError, which points to the place in `sources`.
template <class T>
typename T::Params checked_parameters(const std::string& owner, const YAML::Node& parameters,
                                      const YamlSources& sources) {
  auto loaded = load_parameters<typename T::Params>(parameters, owner, sources);
  if constexpr (HasRules<T>::value) {
    try {
      T::check(loaded);
    } catch (const ConfigError& error) {
      throw ConfigError(with_place(error.what(), parameters, sources));
    }
  }
  return loaded;
}

template <class T>
std::unique_ptr<Component> create_component(Context& context, const YAML::Node& parameters,
                                            const YamlSources& sources) {
  const auto loaded = checked_parameters<T>(context.name, parameters, sources);
  try {
    return std::make_unique<T>(context, loaded);
  } catch (const ConfigError& error) {
    throw ConfigError(with_place(error.what(), parameters, sources));
  }
}

template <class T>
void change_parameters(Component& component, const YAML::Node& parameters,
                       const YamlSources& sources) {
  const auto loaded = checked_parameters<T>(component.name(), parameters, sources);
  if constexpr (TakesParameters<T>::value) {
    T& target = static_cast<T&>(component);
    component.post([&target, loaded] { target.set_parameters(loaded); });
  } else {
    throw ConfigError(component.name() + ": its parameters are fixed while it runs");
  }
}

template <class T>
ComponentEntry make_component_entry() {
  return {component_layout(),
          create_component<T>,
          [](const std::string& owner, const YAML::Node& parameters, const YamlSources& sources) {
            (void)checked_parameters<T>(owner, parameters, sources);
          },
          [] { return default_yaml<typename T::Params>(); },
          [](const std::string& owner, const YAML::Node& parameters, const YamlSources& sources) {
            return parameter_facts(load_parameters<typename T::Params>(parameters, owner, sources));
          },
          change_parameters<T>};
}

}  // namespace tocsin
