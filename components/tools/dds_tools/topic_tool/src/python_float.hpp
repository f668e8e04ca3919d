// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace tocsin::topic_tool {

/// A floating-point number as Python shows it: `1.0`, `0.3`, `inf`.
template <class Number>
[[nodiscard]] std::string python_float(Number value) {
  const std::string digits = fmt::format("{}", value);
  const bool bare = std::isfinite(value) && digits.find_first_of(".e") == std::string::npos;
  return digits + (bare ? ".0" : "");
}

}  // namespace tocsin::topic_tool
