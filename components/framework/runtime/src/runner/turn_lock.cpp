// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/turn_lock.hpp"

#include <chrono>
#include <thread>

namespace tocsin {

void TurnLock::wait() {
  constexpr int looks_awake = 100;  // a gate that keeps or counts is done by then
  for (int looks = 0; taken_.exchange(true, std::memory_order_acquire);) {
    if (++looks > looks_awake) std::this_thread::sleep_for(std::chrono::microseconds(20));
  }
}

}  // namespace tocsin
