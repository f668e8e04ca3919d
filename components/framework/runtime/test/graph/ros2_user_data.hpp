// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cctype>
#include <map>
#include <string>

namespace tocsin {

/// User data as ROS 2 takes it apart: a key of letters and digits, `=`, a value, `;`. Nothing at
/// all when one part is not so. Written after the rule of `rmw`, not after our own reading.
inline std::map<std::string, std::string> ros2_user_data(const std::string& bytes) {
  std::map<std::string, std::string> parts;
  std::size_t at = 0;
  while (at < bytes.size()) {
    if (bytes[at] == '\0' && !parts.empty()) return parts;  // what a C string ends with
    std::string key;
    while (at < bytes.size() && std::isalnum(static_cast<unsigned char>(bytes[at])) != 0) {
      key += bytes[at++];
    }
    if (key.empty() || at >= bytes.size() || bytes[at] != '=') return {};
    std::string value;
    for (++at; at < bytes.size() && bytes[at] != ';'; ++at) value += bytes[at];
    if (value.empty()) return {};
    parts[key] = value;
    while (at < bytes.size() && bytes[at] == ';') ++at;
  }
  return parts;
}

/// The hash of the type that ROS 2 reads there; empty: it reads none, and warns.
inline std::string ros2_type_hash(const std::string& user_data) {
  const auto parts = ros2_user_data(user_data);
  const auto found = parts.find("typehash");
  return found == parts.end() ? "" : found->second;
}

}  // namespace tocsin
