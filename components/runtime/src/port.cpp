// SPDX-License-Identifier: Apache-2.0
#include "runtime/port.hpp"

namespace tocsin {

InputPort::InputPort(Component& owner, const Endpoint& endpoint)
    : owner_(owner), subscription_(owner.bus().subscribe(endpoint, *this)) {}

InputPort::~InputPort() = default;

void InputPort::receive(const Sample& sample) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (queue_.size() == capacity) queue_.pop_front();
    queue_.push_back(sample);
  }
  owner_.schedule().input_arrived();
}

std::optional<Sample> InputPort::take_sample() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.empty()) return std::nullopt;
  Sample sample = std::move(queue_.front());
  queue_.pop_front();
  return sample;
}

}  // namespace tocsin
