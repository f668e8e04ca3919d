// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// Whether it is a hash of a type as ROS 2 writes it, since Iron: `RIHS01_` and 64 digits.
inline bool is_type_hash(const std::string& text) {
  const std::string start = "RIHS01_";
  constexpr std::size_t digits = 64;
  return text.size() == start.size() + digits && text.compare(0, start.size(), start) == 0 &&
         text.find_first_not_of("0123456789abcdef", start.size()) == std::string::npos;
}

}  // namespace tocsin
