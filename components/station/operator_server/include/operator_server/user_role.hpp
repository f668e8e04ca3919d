// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tocsin::foxglove {

/// What a client may do. Everybody may press the emergency stop.
enum class UserRole : std::uint8_t {
  observer,    ///< reads
  driver,      ///< an operator: drives, sends missions, releases the emergency stop
  supervisor,  ///< the same, and takes control of who drives
};
[[nodiscard]] inline constexpr std::array<const char*, 3> words_of(UserRole) {
  return {"observer", "operator", "supervisor"};
}

/// Who knows the token has the role.
struct AccessToken {
  std::string token;
  UserRole role = UserRole::driver;
};

/// The tokens of a file: on each line a role and a token, or a token alone for role `usual`. Empty
/// lines and those that begin with # do not count. Throws ConfigError with `file` and line: a word
/// that is no role, a token that is too short or there twice, no token at all.
[[nodiscard]] std::vector<AccessToken> parse_tokens(const std::string& file,
                                                    const std::string& text, UserRole usual);

}  // namespace tocsin::foxglove
