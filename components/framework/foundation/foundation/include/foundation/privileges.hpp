// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "foundation/account.hpp"

namespace tocsin {

/// Capabilities of Linux, as CAP_NET_ADMIN of <linux/capability.h>.
using Capabilities = std::vector<int>;

/// Root becomes an ordinary user with his groups, home and name, for good: no program that is
/// executed from now on gets rights that this process has not (PR_SET_NO_NEW_PRIVS). Of root's
/// rights this process keeps `kept`, asleep; programs that it starts do not (but see ChildSetup).
/// Call it as root, while there is one thread only. Throws EnvironmentError.
void become_user(const Account& account, const Capabilities& kept);

/// Lets go of all kept capabilities but these, for good. Throws EnvironmentError.
void keep_only(const Capabilities& kept);

/// As long as this lives its thread, and threads that it starts, may use the kept capabilities.
/// Of root it changes nothing.
class AwakeCapabilities {
 public:
  /// Throws EnvironmentError.
  AwakeCapabilities();
  ~AwakeCapabilities();
  AwakeCapabilities(const AwakeCapabilities&) = delete;
  AwakeCapabilities& operator=(const AwakeCapabilities&) = delete;

 private:
  bool was_awake_;
};

/// For a child between fork and exec; false when the kernel refuses. Async-signal-safe.
[[nodiscard]] bool wake_capabilities();
/// The same: the program that is executed next has those, unless root executes it.
[[nodiscard]] bool pass_on_capabilities(const Capabilities& capabilities);

}  // namespace tocsin
