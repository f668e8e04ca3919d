// SPDX-License-Identifier: Apache-2.0
#include "message_pool.hpp"

#include <atomic>

namespace tocsin {

std::shared_ptr<void> MessagePool::take() {
  for (const auto& message : kept_) {
    if (message.use_count() != 1) continue;
    // Pairs with the release in the last holder's destructor: its reads are over.
    std::atomic_thread_fence(std::memory_order_acquire);
    return message;
  }
  std::shared_ptr<void> message = type_.create();
  kept_[next_] = message;
  next_ = (next_ + 1) % kept_.size();
  return message;
}

}  // namespace tocsin
