// SPDX-License-Identifier: Apache-2.0
#include "command_line/launch_user.hpp"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin {
namespace {

constexpr const char* system_user = "tocsin";

UserChoice wished(const std::string& who, const std::string& by, const UserFacts& facts) {
  const auto account = facts.find(who);
  if (!account) {
    throw ConfigError(by + " " + printable(who) +
                      ": no such user; allowed: a name or number of `getent passwd`");
  }
  if (account->id == 0) return {};
  if (const auto path = facts.denied(*account)) {
    throw ConfigError(by + " " + printable(who) + ": " + path->string() +
                      ": may not be used by this user");
  }
  return {account, ""};
}

/// One that nobody has named; with the reason when it cannot be.
UserChoice offered(const Account& account, const std::string& what, const UserFacts& facts) {
  const auto path = facts.denied(account);
  if (!path) return {account, ""};
  return {std::nullopt, "WARN: all processes run as root: " + to_string(account) + ", " + what +
                            ", may not use " + path->string() + "; --user NAME says another, " +
                            "--user root that it shall be so"};
}

/// Whether a user namespace shows one user only, as that of `unshare --map-root-user`.
bool is_alone() {
  std::ifstream map("/proc/self/uid_map");
  std::uint64_t inside = 0;
  std::uint64_t outside = 0;
  std::uint64_t count = 0;
  return map >> inside >> outside >> count && count == 1;
}

}  // namespace

UserChoice choose_user(const UserWishes& wishes, const UserFacts& facts) {
  if (!wishes.option.empty()) return wished(wishes.option, "--user", facts);
  if (!wishes.file.empty()) return wished(wishes.file, "user:", facts);
  const auto caller = wishes.sudo_user.empty() ? std::nullopt : facts.find(wishes.sudo_user);
  if (caller && caller->id != 0) return offered(*caller, "who called sudo", facts);
  if (const auto account = facts.find(system_user)) {
    return offered(*account, "the system's user", facts);
  }
  return {
      std::nullopt,
      "WARN: all processes run as root; make a user for them (adduser --system --group tocsin), "
      "or say --user NAME"};
}

UserChoice choose_user(const std::string& option, const std::string& file,
                       const std::vector<Access>& needed) {
  if (::geteuid() != 0) {
    const auto account = option.empty() ? std::nullopt : find_account(option);
    if (option.empty() || (account && account->id == ::geteuid())) return {};
    throw ConfigError("--user " + printable(option) + ": only root can become another user");
  }
  if (is_alone() && option.empty()) return {};
  const char* const sudo_user = std::getenv("SUDO_UID");
  return choose_user(UserWishes{option, file, sudo_user == nullptr ? "" : sudo_user},
                     UserFacts{find_account, [&needed](const Account& account) {
                                 return first_denied(account, needed);
                               }});
}

}  // namespace tocsin
