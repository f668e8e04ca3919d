// SPDX-License-Identifier: Apache-2.0
#include "runtime/port.hpp"

namespace tocsin {

InputPort::InputPort(Component& owner, const Endpoint& endpoint)
    : owner_(owner), endpoint_(endpoint), subscription_(owner.bus().subscribe(endpoint, *this)) {
  owner_.add_port(*this);
}

InputPort::~InputPort() { owner_.remove_port(*this); }

void InputPort::receive(const Sample& sample) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++received_;
    last_ = sample.received;
    if (!queue_.push(sample)) ++dropped_;
  }
  owner_.schedule().input_arrived();
}

std::optional<Sample> InputPort::take_sample() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.size() == 0) return std::nullopt;
  return queue_.pop();
}

PortHealth InputPort::health() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {endpoint_.topic.name, received_, dropped_, queue_.size(), last_};
}

void InputPort::listen(bool on) {
  if (on == (subscription_ != nullptr)) return;
  if (on) {
    subscription_ = owner_.bus().subscribe(endpoint_, *this);
    return;
  }
  subscription_.reset();
  const std::lock_guard<std::mutex> lock(mutex_);
  queue_.clear();
}

}  // namespace tocsin
