// SPDX-License-Identifier: Apache-2.0
#include "rtps/this_host.hpp"

#include <atomic>
#include <chrono>
#include <random>

#include "foundation/time.hpp"

namespace tocsin {

std::int64_t wall_now_ns() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::uint64_t fresh_source() {
  static std::atomic<std::uint64_t> next{
      (static_cast<std::uint64_t>(std::random_device{}()) << 32U) + std::random_device{}()};
  return next++;
}

}  // namespace tocsin
