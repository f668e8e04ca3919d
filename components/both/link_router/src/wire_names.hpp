// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>

namespace tocsin {

/// Whether what a peer has sent can be the name of a topic, a service or a type: 1 to 255 letters,
/// digits and characters of `also`.
[[nodiscard]] inline bool is_wire_name(const std::string& text, const std::string& also) {
  constexpr std::size_t longest = 255;
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) {
           return std::isalnum(c) != 0 || also.find(static_cast<char>(c)) != std::string::npos;
         });
}

}  // namespace tocsin
