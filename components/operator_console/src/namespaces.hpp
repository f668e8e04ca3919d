// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace tocsin {

/// Moves this program into the user, network and mount namespaces of a process: into the emulated
/// host that `tocsin launch` has made. The working folder becomes `/`. Must be called while there
/// is one thread only. Throws EnvironmentError.
void enter_namespaces(pid_t process);

}  // namespace tocsin
