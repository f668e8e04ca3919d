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
/// of bytes only the number is kept. NaN is the empty text.
[[nodiscard]] std::vector<FlatField> flatten(const TypeInfo& type, const void* message);

/// `text` as one CSV cell (RFC 4180): quoted when it holds a comma, quote or line break.
[[nodiscard]] std::string csv_cell(const std::string& text);

}  // namespace tocsin
