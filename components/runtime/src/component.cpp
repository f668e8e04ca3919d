// SPDX-License-Identifier: Apache-2.0
#include "runtime/component.hpp"

#include <utility>

namespace tocsin {

void Schedule::input_arrived() {
  input_pending.store(true, std::memory_order_release);
  const std::lock_guard<std::mutex> lock(wake_mutex_);
  if (wake_) wake_();
}

void Schedule::set_wake(std::function<void()> wake) {
  const std::lock_guard<std::mutex> lock(wake_mutex_);
  wake_ = std::move(wake);
}

void Schedule::begin_tick(Time now) {
  input_pending.store(false, std::memory_order_relaxed);
  deadline = never;
  if (period <= Duration::zero()) return;
  if (next_period == never) {
    next_period = now + period;
  } else if (now >= next_period) {
    next_period += period;
    if (next_period <= now) {
      overruns += static_cast<std::uint64_t>((now - next_period) / period) + 1;
      next_period = now + period;
    }
  }
}

void Component::wake_at(Time deadline) {
  schedule_.deadline = std::min(schedule_.deadline, deadline);
}

void Component::forget(int descriptor) {
  auto& all = schedule_.descriptors;
  all.erase(std::remove(all.begin(), all.end(), descriptor), all.end());
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
