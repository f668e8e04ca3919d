// SPDX-License-Identifier: Apache-2.0
#include "foundation/account.hpp"

#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "foundation/privileges.hpp"

namespace tocsin {
namespace {

/// -1 means "none" to the kernel, and is nobody's.
std::optional<uid_t> number_of(const std::string& text) {
  uid_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const bool is_one = error == std::errc() && rest == end;
  if (!is_one || number == std::numeric_limits<uid_t>::max()) return std::nullopt;
  return number;
}

/// What the child tells when it could not even look.
constexpr int cannot_look = 255;
constexpr std::size_t most_paths = 254;

int index_of_denied(const Account& account, const std::vector<Access>& all) {
  try {
    become_user(account, {});
  } catch (const EnvironmentError&) {
    return cannot_look;
  }
  const auto denied = std::find_if(all.begin(), all.end(), [](const Access& one) {
    return ::access(one.path.c_str(), one.mode) != 0;
  });
  return static_cast<int>(denied - all.begin());
}

}  // namespace

std::string to_string(const Account& account) {
  return account.name.empty() ? "user " + std::to_string(account.id) : account.name;
}

std::optional<Account> find_account(const std::string& name_or_number) {
  const auto number = number_of(name_or_number);
  const passwd* found = ::getpwnam(name_or_number.c_str());  // a name may be digits
  if (found == nullptr && number) found = ::getpwuid(*number);
  if (found != nullptr) return Account{found->pw_name, found->pw_uid, found->pw_gid, found->pw_dir};
  if (number) return Account{"", *number, *number};
  return std::nullopt;
}

std::optional<std::filesystem::path> first_denied(const Account& account,
                                                  const std::vector<Access>& all) {
  if (all.size() > most_paths) throw EnvironmentError("too many paths to look at");
  const pid_t child = ::fork();
  if (child < 0) throw EnvironmentError("cannot start a process: fork failed");
  if (child == 0) ::_exit(index_of_denied(account, all));
  const auto index = static_cast<std::size_t>(wait_for_child(child));
  if (index > all.size()) throw EnvironmentError("cannot become " + to_string(account));
  if (index == all.size()) return std::nullopt;
  return all[index].path;
}

}  // namespace tocsin
