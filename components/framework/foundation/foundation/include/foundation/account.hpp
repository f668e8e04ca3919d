// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// A user of this computer.
struct Account {
  std::string name;  ///< empty when the list of users has none of this number
  uid_t id = 0;
  gid_t group = 0;
  std::string home = "/";
};

/// "bob", or "user 1001" of one without a name.
[[nodiscard]] std::string to_string(const Account& account);

/// The user of that name or number. A number that the list of users does not have is one, too,
/// whose group has the same number. Nothing when a name is unknown, or a number no user's.
[[nodiscard]] std::optional<Account> find_account(const std::string& name_or_number);

/// What somebody must be able to do with a file: R_OK, W_OK and X_OK of access(2).
struct Access {
  std::filesystem::path path;
  int mode = 0;
};

/// The first of them that the user may not; nothing when he may all. Asked by a process that has
/// become him, so call it as root, while there is one thread only. Throws EnvironmentError.
[[nodiscard]] std::optional<std::filesystem::path> first_denied(const Account& account,
                                                                const std::vector<Access>& all);

}  // namespace tocsin
