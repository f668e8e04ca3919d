// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace tocsin {

inline constexpr double pi = 3.14159265358979323846;
/// In rad.
inline constexpr double degree = pi / 180;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// "Not known" where a message or a table has no other way to say it.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace tocsin
