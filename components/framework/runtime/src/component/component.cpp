// SPDX-License-Identifier: Apache-2.0
#include "runtime/component.hpp"

#include <utility>

#include "runtime/port.hpp"

namespace tocsin {
namespace {

thread_local const Waker* waker_of_this_thread = nullptr;

}  // namespace

void Waker::claim_this_thread() const { waker_of_this_thread = this; }

// From the thread that ticks the component, which looks before it sleeps: nothing to wake, and
// nobody else to agree with. From another, the flag and the waker pair up with the runner, which
// stores its waker, or that it sleeps, before it looks at the flag: one of the two sees the other.
void Schedule::input_arrived() {
  const Waker* const waker = waker_of_this_thread;
  if (waker != nullptr && waker_.load(std::memory_order_relaxed) == waker) {
    own_input_.store(true, std::memory_order_relaxed);
    return;
  }
  if (input_pending.exchange(true)) return;  // whoever set it has woken, too
  if (waker_.load() == nullptr) return;
  const std::lock_guard<TurnLock> lock(wake_turn_);
  if (Waker* const still = waker_.load(std::memory_order_relaxed)) still->wake();
}

void Schedule::set_waker(Waker* waker) {
  const std::lock_guard<TurnLock> lock(wake_turn_);
  waker_.store(waker);
}

void Schedule::begin_tick(Time now) {
  own_input_.store(false, std::memory_order_relaxed);
  if (input_pending.load(std::memory_order_relaxed)) {
    input_pending.exchange(false);  // reads what the input's thread did before it set it
  }
  deadline = never;
  begun_ = now;
  if (period <= Duration::zero()) return;
  if (next_period == never) {
    next_period = now + period;
  } else if (now >= next_period) {
    next_period += period;
    if (next_period <= now) {
      overruns += static_cast<std::uint64_t>((now - next_period) / period) + 1U;
      next_period = now + period;
    }
  }
}

void Schedule::repeat(Duration wanted) {
  period = wanted;
  next_period = begun_ == never ? never : begun_ + wanted;
}

void Component::wake_at(Time deadline) {
  schedule_.deadline = std::min(schedule_.deadline, deadline);
}

void Component::forget(int descriptor) {
  auto& all = schedule_.descriptors;
  all.erase(std::remove(all.begin(), all.end(), descriptor), all.end());
}

void Component::add_port(InputPort& port) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  ports_.push_back(&port);
}

void Component::remove_port(InputPort& port) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  ports_.erase(std::remove(ports_.begin(), ports_.end(), &port), ports_.end());
}

std::vector<PortHealth> Component::port_health() const {
  std::vector<PortHealth> all;
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  for (const InputPort* port : ports_) all.push_back(port->health());
  return all;
}

void Component::listen(bool on) {
  const std::lock_guard<std::mutex> lock(ports_mutex_);
  for (InputPort* port : ports_) port->listen(on);
}

builtin_interfaces::msg::Time Component::wall(Time now) const {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t ns = context_.bus.wall_ns(now);
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(ns / second));
  stamp.nanosec(static_cast<std::uint32_t>(ns % second));
  return stamp;
}

}  // namespace tocsin
