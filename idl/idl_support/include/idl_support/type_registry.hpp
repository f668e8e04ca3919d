// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// Makes a type known by its wire name. Called by generated code before main.
void register_type(const TypeInfo& info);

/// The type of this wire name, or nullptr when no loaded library has it. Any thread.
[[nodiscard]] const TypeInfo* find_type(const std::string& name);

}  // namespace tocsin
