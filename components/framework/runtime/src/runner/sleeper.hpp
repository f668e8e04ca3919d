// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <poll.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "runtime/component.hpp"

namespace tocsin {

/// Lets one thread sleep until a deadline, a descriptor or a call of `wake`. Without descriptors it
/// sleeps on a futex, which wakes faster than a poll. Waking a thread that is awake costs no
/// system call.
class Sleeper final : public Waker {
 public:
  Sleeper();
  ~Sleeper();
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

  void wake() override;
  /// From now on a call of `wake` ends the next `sleep`. The caller then looks whether there is
  /// work, and sleeps if not.
  void announce() { state_.store(announced); }
  /// Only after announce. Returns at `due`, when woken, or when a descriptor is readable: true
  /// then.
  bool sleep(Time due, const std::vector<int>& descriptors);

 private:
  enum State : std::uint32_t { awake, announced, on_futex, in_poll };
  void sleep_on_futex(Time due);
  bool poll_until(Time due, const std::vector<int>& descriptors);

  std::atomic<std::uint32_t> state_{awake};
  int wake_fd_;
  std::vector<pollfd> polled_;
};

}  // namespace tocsin
