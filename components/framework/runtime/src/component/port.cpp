// SPDX-License-Identifier: Apache-2.0
#include "runtime/port.hpp"

#include <utility>

namespace tocsin {
namespace {

Endpoint of_node(Endpoint endpoint, const std::string& node) {
  endpoint.node = node;
  return endpoint;
}

}  // namespace

InputPort::InputPort(Component& owner, const Endpoint& endpoint, WakeMode wake_mode)
    : owner_(owner),
      endpoint_(of_node(endpoint, owner.node())),
      wake_mode_(wake_mode),
      subscription_(owner.bus().subscribe(endpoint_, *this)) {
  owner_.add_port(*this);
}

InputPort::~InputPort() { owner_.remove_port(*this); }

void InputPort::receive_last(Sample&& sample) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++received_;
    last_ = sample.received;
    if (!queue_.push(std::move(sample))) ++dropped_;
    has_sample_.store(true, std::memory_order_relaxed);
  }
  if (wake_mode_ == WakeMode::event_triggered) owner_.schedule().input_arrived();
}

// A tick that an input asked for sees the flag that was set before, see Schedule::begin_tick.
// Another may miss it, and the next one sees it.
std::optional<Sample> InputPort::take_sample() {
  if (!has_sample()) return std::nullopt;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.size() == 0) return std::nullopt;
  has_sample_.store(queue_.size() > 1, std::memory_order_relaxed);
  return queue_.pop();
}

std::shared_ptr<const void> InputPort::take_message() {
  if (!has_sample()) return nullptr;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queue_.size() == 0) return nullptr;
  has_sample_.store(queue_.size() > 1, std::memory_order_relaxed);
  return queue_.pop().message;
}

PortHealth InputPort::health() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {endpoint_.topic.name, received_, dropped_, queue_.size(), last_};
}

std::optional<WriterInfo> InputPort::writer(std::uint64_t source) const {
  return subscription_ ? subscription_->writer(source) : std::nullopt;
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
  has_sample_.store(false, std::memory_order_relaxed);
}

}  // namespace tocsin
