// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// Removes from `folder` what Fast DDS's shared-memory transport left there when its process was
/// killed: segments and ports whose lock file nobody holds. Returns the number of segments and
/// ports. Errors are passed over: another user's files, or another process was faster.
int remove_shared_memory_leftovers(const std::string& folder = "/dev/shm");

}  // namespace tocsin
