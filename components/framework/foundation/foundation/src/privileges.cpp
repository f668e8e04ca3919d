// SPDX-License-Identifier: Apache-2.0
#include "foundation/privileges.hpp"

#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

/// The sets of this thread, as capget(2) has them. The C library has no function for it, and
/// libcap's take memory, which a child between fork and exec may not.
struct Sets {
  std::uint64_t effective = 0;
  std::uint64_t permitted = 0;
  std::uint64_t inheritable = 0;
};

using Halves = std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3>;
constexpr unsigned half = 32;

std::uint64_t joined(std::uint32_t low, std::uint32_t high) {
  return low | static_cast<std::uint64_t>(high) << half;
}

bool get(Sets& sets) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  Halves data{};
  if (::syscall(SYS_capget, &header, data.data()) != 0) return false;
  sets = {joined(data[0].effective, data[1].effective),
          joined(data[0].permitted, data[1].permitted),
          joined(data[0].inheritable, data[1].inheritable)};
  return true;
}

bool set(const Sets& sets) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  Halves data{};
  for (unsigned i = 0; i < data.size(); ++i) {
    const auto part = [i](std::uint64_t all) {
      return static_cast<std::uint32_t>(all >> (half * i));
    };
    data[i] = {part(sets.effective), part(sets.permitted), part(sets.inheritable)};
  }
  return ::syscall(SYS_capset, &header, data.data()) == 0;
}

std::uint64_t bits_of(const Capabilities& capabilities) {
  std::uint64_t bits = 0;
  for (const int each : capabilities) bits |= std::uint64_t{1} << static_cast<unsigned>(each);
  return bits;
}

[[noreturn]] void fail(const std::string& what) {
  throw EnvironmentError(what + ": " + std::system_category().message(errno));
}

bool take_groups(const Account& account) {
  if (account.name.empty()) return ::setgroups(0, nullptr) == 0;
  return ::initgroups(account.name.c_str(), account.group) == 0;
}

void take_environment(const Account& account) {
  ::setenv("HOME", account.home.c_str(), 1);
  for (const char* variable : {"USER", "LOGNAME"}) {
    if (account.name.empty()) {
      ::unsetenv(variable);
    } else {
      ::setenv(variable, account.name.c_str(), 1);
    }
  }
}

}  // namespace

void become_user(const Account& account, const Capabilities& kept) {
  const gid_t group = account.group;
  const uid_t id = account.id;
  if (::prctl(PR_SET_KEEPCAPS, 1) != 0 || !take_groups(account) ||
      ::setresgid(group, group, group) != 0 || ::setresuid(id, id, id) != 0) {
    fail("cannot become " + to_string(account));
  }
  keep_only(kept);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("cannot give up new privileges");
  take_environment(account);
}

void keep_only(const Capabilities& kept) {
  Sets sets;
  const bool known = get(sets);
  sets = {0, sets.permitted & bits_of(kept), 0};
  if (!known || !set(sets)) fail("cannot give up capabilities");
}

AwakeCapabilities::AwakeCapabilities() : was_awake_(false) {
  Sets sets;
  const bool known = get(sets);
  was_awake_ = sets.effective == sets.permitted;
  if (!known || !wake_capabilities()) fail("cannot use capabilities");
}

AwakeCapabilities::~AwakeCapabilities() {
  Sets sets;
  if (was_awake_ || !get(sets)) return;
  sets.effective = 0;
  if (!set(sets)) std::abort();  // to go on with rights that nobody expects is worse
}

bool wake_capabilities() {
  Sets sets;
  if (!get(sets)) return false;
  if (sets.effective == sets.permitted) return true;
  sets.effective = sets.permitted;
  return set(sets);
}

bool pass_on_capabilities(const Capabilities& capabilities) {
  Sets sets;
  // A service's sandbox lets nobody ask for capabilities, and who passes none on need not.
  if (::geteuid() == 0 || capabilities.empty()) return true;
  if (!get(sets)) return false;
  sets.inheritable |= bits_of(capabilities);
  return set(sets) && std::all_of(capabilities.begin(), capabilities.end(), [](int each) {
           return ::prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_RAISE, each, 0, 0) == 0;
         });
}

}  // namespace tocsin
