// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// 16 hex digits that differ between types whose fields differ in order, name, kind or width, at
/// any depth; the same on every machine. Empty for a type that contains itself.
///
/// A type is known only by its functions. So it is shown bytes of which each field takes its own,
/// with every list and text one element long, and the digest is over what it made of them.
[[nodiscard]] std::string layout_digest(const TypeInfo& type);

}  // namespace tocsin
