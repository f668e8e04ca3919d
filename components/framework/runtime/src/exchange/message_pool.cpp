// SPDX-License-Identifier: Apache-2.0
#include "exchange/message_pool.hpp"

#include <utility>

namespace tocsin {

std::shared_ptr<void> MessagePool::take() {
  constexpr std::size_t most_kept = 4;
  std::shared_ptr<void> message;
  {
    const std::lock_guard<std::mutex> lock(shelf_->mutex);
    if (!shelf_->messages.empty()) {
      message = std::move(shelf_->messages.back());
      shelf_->messages.pop_back();
    }
  }
  if (!message) message = type_.create();
  void* const content = message.get();
  const auto give_back = [shelf = shelf_, owner = std::move(message)](void*) mutable {
    const std::lock_guard<std::mutex> lock(shelf->mutex);
    if (shelf->messages.size() < most_kept) shelf->messages.push_back(std::move(owner));
  };
  return {content, give_back};
}

}  // namespace tocsin
