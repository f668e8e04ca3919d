// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// One column of a message: `header.stamp.sec`, `12`.
struct FlatField {
  std::string name;
  std::string value;
};

/// Spreads a message into columns, always the same ones for a type. A list is one column in JSON;
/// of bytes, and of more than 4096 elements, only the number is kept. NaN is the empty text; a text
/// is printable() and has at most 4096 bytes of the original.
[[nodiscard]] std::vector<FlatField> flatten(const TypeInfo& type, const void* message);

}  // namespace tocsin
