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
class Sleeper : public Waker {
 public:
  Sleeper();
  ~Sleeper();
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

  void wake() override;
  /// From now on a call of `wake` ends the next `sleep`. The caller then looks whether there is
  /// work, and sleeps if not.
  void announce() { state_.store(announced); }
  /// Only after announce. Returns at `due`, when a descriptor is readable, or when woken.
  void sleep(Time due, const std::vector<int>& descriptors);
  /// Looks at the descriptors without sleeping.
  void look(const std::vector<int>& descriptors);
  /// The descriptors that were readable at the last sleep or look.
  [[nodiscard]] const std::vector<int>& readable() const { return readable_; }
  void forget_readable() { readable_.clear(); }

 private:
  enum State : std::uint32_t { awake, announced, on_futex, in_poll };
  void sleep_on_futex(Time due);
  void poll_until(Time due, const std::vector<int>& descriptors);

  std::atomic<std::uint32_t> state_{awake};
  int wake_fd_;
  std::vector<pollfd> polled_;
  std::vector<int> readable_;
};

}  // namespace tocsin
