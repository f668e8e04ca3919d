// SPDX-License-Identifier: Apache-2.0
#include "foundation/role.hpp"

namespace tocsin {

const char* to_string(Role role) { return role == Role::uxv ? "uxv" : "gcs"; }

std::optional<Role> role_of(std::string_view word) {
  for (const Role one : roles) {
    if (word == to_string(one)) return one;
  }
  return std::nullopt;
}

}  // namespace tocsin
