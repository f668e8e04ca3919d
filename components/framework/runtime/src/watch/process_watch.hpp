// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "watch/patient_clock.hpp"
#include "watch/watchdog.hpp"

namespace tocsin {

/// The exit code by which a process asks to be started again: EX_TEMPFAIL of sysexits.h.
constexpr int start_me_again = 75;

/// Looks at this process's threads of DDS and its memory, on a thread of its own that takes no lock
/// which they could hold.
class ProcessWatch {
 public:
  /// `tell` is called on that thread with each finding once, and once more when it is final, which
  /// is the last that is looked at; it may end the process.
  ProcessWatch(const WatchLimits& limits, std::function<void(const WatchFinding&)> tell);
  ~ProcessWatch();
  ProcessWatch(const ProcessWatch&) = delete;
  ProcessWatch& operator=(const ProcessWatch&) = delete;

  /// What is wrong now. Any thread.
  [[nodiscard]] std::optional<std::string> finding() const;

 private:
  void run();

  const Duration period_;
  const std::function<void(const WatchFinding&)> tell_;
  PatientClock clock_;
  Watchdog watchdog_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::optional<std::string> finding_;
  std::thread thread_;  // last: it uses all of this
};

/// Takes no more private memory than that from the kernel, stacks included; who asks for more gets
/// std::bad_alloc. Not where an instrumented build keeps its shadow memory.
void limit_private_memory(std::uint64_t bytes);

}  // namespace tocsin
