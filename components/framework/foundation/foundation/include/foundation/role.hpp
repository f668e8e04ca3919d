// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tocsin {

/// What a host is: a vehicle, or a ground station. (Which host it is, its name tells.)
enum class Role : std::uint8_t { uxv, gcs };

inline constexpr std::array<Role, 2> roles{Role::uxv, Role::gcs};

/// The word of a bringup or traffic file and of messages: "uxv" or "gcs".
[[nodiscard]] const char* to_string(Role role);
/// The role of a word; empty when it is none.
[[nodiscard]] std::optional<Role> role_of(std::string_view word);

}  // namespace tocsin
