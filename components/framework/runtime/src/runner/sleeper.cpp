// SPDX-License-Identifier: Apache-2.0
#include "runner/sleeper.hpp"

#include <linux/futex.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace tocsin {
namespace {

timespec to_timespec(Duration d) {
  constexpr Duration::rep second = 1'000'000'000;
  return {static_cast<time_t>(d.count() / second), static_cast<long>(d.count() % second)};
}

long futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value,
           const timespec* until) {
  static_assert(sizeof word == sizeof(std::uint32_t));
  return syscall(SYS_futex, &word, operation | FUTEX_PRIVATE_FLAG, value, until, nullptr,
                 FUTEX_BITSET_MATCH_ANY);
}

}  // namespace

Sleeper::Sleeper() : wake_fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

Sleeper::~Sleeper() { close(wake_fd_); }

void Sleeper::wake() {
  const std::uint32_t was = state_.exchange(awake);
  if (was == on_futex) {
    futex(state_, FUTEX_WAKE, 1, nullptr);
  } else if (was == in_poll) {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(wake_fd_, &one, sizeof one);
  }
}

bool Sleeper::sleep(Time due, const std::vector<int>& descriptors) {
  std::uint32_t expected = announced;
  if (!state_.compare_exchange_strong(expected, descriptors.empty() ? on_futex : in_poll)) {
    return false;
  }
  bool readable = false;
  if (descriptors.empty()) {
    sleep_on_futex(due);
  } else {
    readable = poll_until(due, descriptors);
  }
  state_.store(awake);
  return readable;
}

// The futex's clock is CLOCK_MONOTONIC, that of Time.
void Sleeper::sleep_on_futex(Time due) {
  const timespec until = to_timespec(std::max(due, Time{}).time_since_epoch());
  futex(state_, FUTEX_WAIT_BITSET, on_futex, due == never ? nullptr : &until);
}

bool Sleeper::poll_until(Time due, const std::vector<int>& descriptors) {
  constexpr Duration longest = std::chrono::hours(1);
  const Time now = std::chrono::steady_clock::now();
  const timespec timeout =
      to_timespec(due <= now ? Duration::zero() : std::min(due - now, longest));
  polled_.assign(1, {wake_fd_, POLLIN, 0});
  for (const int descriptor : descriptors) polled_.push_back({descriptor, POLLIN, 0});
  if (ppoll(polled_.data(), polled_.size(), &timeout, nullptr) <= 0) return false;
  if (polled_[0].revents != 0) {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto drained = read(wake_fd_, &count, sizeof count);
  }
  return std::any_of(polled_.begin() + 1, polled_.end(),
                     [](const pollfd& one) { return one.revents != 0; });
}

}  // namespace tocsin
