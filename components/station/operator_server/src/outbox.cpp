// SPDX-License-Identifier: Apache-2.0
#include "operator_server/outbox.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::foxglove {

void Outbox::add_control(Frame frame) {
  control_bytes_ += frame.size();
  control_.push_back(std::move(frame));
}

void Outbox::add_data(std::uint32_t subscription, Frame frame) {
  std::deque<Frame>& waiting = data_[subscription];
  if (waiting.empty()) turns_.push_back(subscription);
  data_bytes_ += frame.size();
  waiting.push_back(std::move(frame));
  while (waiting.size() > limits_.backlog ||
         (waiting.size() > 1 && data_bytes_ > limits_.data_bytes)) {
    drop_oldest(subscription);
  }
}

void Outbox::drop_oldest(std::uint32_t subscription) {
  std::deque<Frame>& waiting = data_[subscription];
  data_bytes_ -= waiting.front().size();
  waiting.pop_front();
  ++drops_[subscription];
}

void Outbox::forget(std::uint32_t subscription) {
  const auto found = data_.find(subscription);
  drops_.erase(subscription);
  if (found == data_.end()) return;
  for (const Frame& frame : found->second) data_bytes_ -= frame.size();
  data_.erase(found);
  turns_.erase(std::remove(turns_.begin(), turns_.end(), subscription), turns_.end());
}

std::optional<Frame> Outbox::next() {
  if (!control_.empty()) {
    Frame frame = std::move(control_.front());
    control_.pop_front();
    control_bytes_ -= frame.size();
    return frame;
  }
  if (time_) return std::exchange(time_, std::nullopt);
  if (turns_.empty()) return std::nullopt;
  const std::uint32_t subscription = turns_.front();
  turns_.pop_front();
  std::deque<Frame>& waiting = data_[subscription];
  Frame frame = std::move(waiting.front());
  waiting.pop_front();
  data_bytes_ -= frame.size();
  if (waiting.empty()) {
    data_.erase(subscription);
  } else {
    turns_.push_back(subscription);
  }
  return frame;
}

std::vector<Frame> Outbox::take(std::size_t bytes) {
  std::vector<Frame> frames;
  std::size_t taken = 0;
  while (taken < bytes || frames.empty()) {
    auto frame = next();
    if (!frame) break;
    taken += frame->size();
    frames.push_back(std::move(*frame));
  }
  return frames;
}

bool Outbox::empty() const { return control_.empty() && !time_ && turns_.empty(); }

std::map<std::uint32_t, std::uint64_t> Outbox::take_drops() { return std::exchange(drops_, {}); }

}  // namespace tocsin::foxglove
