// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"

namespace tocsin::deployment {

/// One host of a `tocsin launch` that runs on this computer.
struct RunningHost {
  Deployment deployment;
  std::string host;  ///< its name
  pid_t process;     ///< one of its containers

  /// Never fails: the host is one of the deployment.
  [[nodiscard]] const Host& itself() const { return *find_host(deployment, host); }
  /// Whether it belongs to the run with that folder, which may be gone.
  [[nodiscard]] bool is_of(const std::string& run_dir) const;
};

/// What runs on this computer, as its processes themselves tell.
struct RunningHosts {
  std::vector<RunningHost> hosts;  ///< in the order of their oldest process
  /// Processes of that name into which this user does not look: those of others, and who names no
  /// file of a run.
  std::vector<pid_t> hidden;
};

/// Looks through the processes, and reads the copy of the resolved file that each container holds
/// in memory. Needs no run folder, no launcher and no room. Never waits, whatever a process says of
/// itself: looks at the user's own processes only, root also at those of others whose program is
/// the tocsin-container of this installation, and opens regular files only. `proc`: where the
/// kernel shows them; `user`: who looks, this process's user by default.
[[nodiscard]] RunningHosts running_hosts(const std::string& proc = "/proc",
                                         std::optional<uid_t> user = std::nullopt);

/// The host of that name or role, empty: the first one, of the run with that folder. Throws
/// EnvironmentError when nothing runs there, ConfigError when the run has no such host.
[[nodiscard]] RunningHost running_host(const std::string& run_dir, const std::string& host,
                                       const std::string& proc = "/proc");

/// Moves this program into the user, network and mount namespaces of a process, when its network is
/// another one: into the emulated host that `tocsin launch` has made. The working folder stays.
/// Root becomes the user of the process, whose participants hear no other. Must be called while
/// there is one thread only. Throws EnvironmentError.
void enter_namespaces(pid_t process);

}  // namespace tocsin::deployment
