// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/deferred_reception.hpp"

#include <chrono>

namespace tocsin {

void DeferredReception::release() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    released_ = true;
  }
  changed_.notify_all();
}

void DeferredReception::wait() {
  if (released_.load(std::memory_order_acquire)) return;
  std::unique_lock<std::mutex> lock(mutex_);
  (void)changed_.wait_for(lock, std::chrono::seconds(1), [this] { return released_.load(); });
}

}  // namespace tocsin
