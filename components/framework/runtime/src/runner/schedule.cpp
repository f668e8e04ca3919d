// SPDX-License-Identifier: Apache-2.0
#include "runtime/detail/schedule.hpp"

#include <string>

#include "foundation/hash.hpp"

namespace tocsin {
namespace {

/// Lets every bit of `x` reach every bit of the result (splitmix64's finish).
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

}  // namespace

std::uint64_t process_seed(int run_seed, std::string_view host, std::string_view process) {
  std::string text = std::to_string(run_seed);
  text.append("/").append(host).append("/").append(process);
  return hash_of(text);
}

double phase_of(std::uint64_t seed, std::string_view component) {
  constexpr double unit = 1.0 / (1ULL << 53U);
  return static_cast<double>(mixed(seed ^ mixed(hash_of(component))) >> 11U) * unit;
}

Time PeriodicInstants::after(Time now) const {
  const Duration offset(static_cast<Duration::rep>(phase * static_cast<double>(period.count())));
  const Duration least = now.time_since_epoch() + period / 2 - offset;
  const Duration::rep number = least.count() / period.count();
  const bool exact = number * period.count() >= least.count();
  return Time(offset + (exact ? number : number + 1) * period);
}

// The flag and the waker pair up with the runner, which stores its waker, or that it sleeps, before
// it looks at the flag: one of the two sees the other.
void Schedule::input_arrived() {
  if (input_pending.exchange(true)) return;  // whoever set it has woken, too
  if (waker_.load() == nullptr) return;
  const std::lock_guard<std::mutex> lock(waker_mutex_);
  if (Waker* const still = waker_.load(std::memory_order_relaxed)) still->wake();
}

void Schedule::set_waker(Waker* waker) {
  const std::lock_guard<std::mutex> lock(waker_mutex_);
  waker_.store(waker);
}

void Schedule::begin_tick(Time now) {
  if (input_pending.load(std::memory_order_relaxed)) {
    input_pending.exchange(false);  // reads what the input's thread did before it set it
  }
  deadline = never;
  begun_ = now;
  if (!period) return;
  if (next_period == never) {
    next_period = period->after(now);
  } else if (now >= next_period) {
    const auto missed = (now - next_period) / period->period;
    overruns += static_cast<std::uint64_t>(missed);
    next_period += (missed + 1) * period->period;
  }
}

void Schedule::repeat(const PeriodicInstants& wanted) {
  period = wanted;
  next_period = begun_ == never ? never : wanted.after(begun_);
}

}  // namespace tocsin
