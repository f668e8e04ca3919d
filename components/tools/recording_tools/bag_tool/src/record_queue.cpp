// SPDX-License-Identifier: Apache-2.0
#include "record_queue.hpp"

#include <utility>

namespace tocsin::bag_tool {

void RecordQueue::push(std::size_t topic, RawSample&& sample) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t bytes = sample.bytes->size();
    if (!items_.empty() && bytes_ + bytes > most_bytes_) {
      ++dropped_;
      return;
    }
    bytes_ += bytes;
    items_.push_back({topic, std::move(sample)});
  }
  came_.notify_one();
}

std::vector<RecordQueue::Item> RecordQueue::take(Duration patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  came_.wait_for(lock, patience, [this] { return !items_.empty(); });
  bytes_ = 0;
  return std::exchange(items_, {});
}

std::uint64_t RecordQueue::dropped() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return dropped_;
}

}  // namespace tocsin::bag_tool
