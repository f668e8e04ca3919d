// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>

namespace tocsin::deployment {

/// A living process of a host of a running `tocsin launch`, by the list `processes.json` that the
/// launcher keeps in the run folder. Throws EnvironmentError when there is none.
[[nodiscard]] pid_t process_of(const std::string& run_dir, const std::string& host);

/// Moves this program into the user, network and mount namespaces of a process: into the emulated
/// host that `tocsin launch` has made. The working folder stays. Must be called while there is one
/// thread only. Throws EnvironmentError.
void enter_namespaces(pid_t process);

}  // namespace tocsin::deployment
