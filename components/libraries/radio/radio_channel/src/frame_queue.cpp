// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/frame_queue.hpp"

namespace tocsin::radio {
namespace {

/// About one frame of 1500 bytes at a middle rate.
constexpr Duration quantum = std::chrono::microseconds(300);

}  // namespace

void FrameQueue::pop_front() {
  queues_[current_].pop_front();
  if (--frames_ == 0 || queues_.size() == 1) return;
  while (queues_[current_].empty() || credits_[current_] <= Duration::zero()) {
    // Who has nothing to send saves up nothing either.
    Duration& credit = credits_[current_];
    credit = queues_[current_].empty() ? Duration::zero() : credit + quantum;
    current_ = (current_ + 1) % queues_.size();
  }
}

}  // namespace tocsin::radio
