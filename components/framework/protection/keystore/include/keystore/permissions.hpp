// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::keystore {

/// What an identity may do on the link: DDS topic names, such as `rt/uxv1/location`. `*` and `?`
/// stand for any text and any character (POSIX fnmatch, DDS Security 1.1 section 9.4.1.3).
struct Permissions {
  std::vector<std::string> publish;
  std::vector<std::string> subscribe;
};

[[nodiscard]] inline bool operator==(const Permissions& one, const Permissions& other) {
  return one.publish == other.publish && one.subscribe == other.subscribe;
}
[[nodiscard]] inline bool operator!=(const Permissions& one, const Permissions& other) {
  return !(one == other);
}

}  // namespace tocsin::keystore
