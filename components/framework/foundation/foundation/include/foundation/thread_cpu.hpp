// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

#include "foundation/time.hpp"

namespace tocsin {

/// CPU time that the calling thread has used. A system call.
[[nodiscard]] inline Duration thread_cpu() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
}

}  // namespace tocsin
