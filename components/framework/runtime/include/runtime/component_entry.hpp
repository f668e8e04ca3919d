// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/detail/component_parts.hpp"

/// Makes a class loadable by its library's name: once, at the end of the component's .cpp file.
///
/// A component with live parameters has `void set_parameters(const Params&)`, which is called
/// between two ticks with values that are checked; rules across them are in
/// `static void check(const Params&)`, which throws ConfigError.
#define TOCSIN_COMPONENT(Class)                                                        \
  extern "C" const tocsin::ComponentEntry* tocsin_component() {                        \
    static const tocsin::ComponentEntry entry = tocsin::make_component_entry<Class>(); \
    return &entry;                                                                     \
  }
