// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "foundation/account.hpp"

namespace tocsin {

/// Who has said as whom the processes of a launch by root shall run; empty: nobody.
struct UserWishes {
  std::string option;     ///< of `--user`
  std::string file;       ///< of the bringup file's `user`
  std::string sudo_user;  ///< who called sudo, a number
};

/// What is known of the users of this computer.
struct UserFacts {
  std::function<std::optional<Account>(const std::string&)> find;
  /// What a user would need and may not have; nothing when he may have all.
  std::function<std::optional<std::filesystem::path>(const Account&)> denied;
};

struct UserChoice {
  std::optional<Account> account;  ///< none: nobody else than who has started the program
  std::string warning;             ///< one line, when root stays root and nobody has wished so
};

/// Whom a program that was started by root becomes: `--user`, else the file's `user`, else who
/// called sudo, else the system user `tocsin`. A wish that cannot be fulfilled is refused; of the
/// last two one that cannot be used is passed over with a warning. Throws ConfigError.
[[nodiscard]] UserChoice choose_user(const UserWishes& wishes, const UserFacts& facts);

/// The same for this process; nobody when it is not root's, or root's of a user namespace that has
/// nobody else. Call it while there is one thread only. Throws ConfigError, EnvironmentError.
[[nodiscard]] UserChoice choose_user(const std::string& option, const std::string& file,
                                     const std::vector<Access>& needed);

}  // namespace tocsin
