// SPDX-License-Identifier: Apache-2.0
// When a component runs next: for those who run components.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// What the components of a process draw their phases from: the same for the same run, in reality
/// as in simulation, and another for each process of it.
[[nodiscard]] std::uint64_t process_seed(int run_seed, std::string_view host,
                                         std::string_view process);

/// Where in its period a component does what it does periodically: in [0, 1), uniform over seeds
/// and names.
[[nodiscard]] double phase_of(std::uint64_t seed, std::string_view component);

/// Instants at which something is done each `period`: multiples of it on the bus's clock, and
/// `phase` of it. So what was late once is not late for ever, and a process that is restarted
/// takes the instants up that it had.
struct PeriodicInstants {
  Duration period;   ///< > 0
  double phase = 0;  ///< [0, 1)

  /// The first that is at least half a period later than `now`, at which it was done.
  [[nodiscard]] Time after(Time now) const;
};

/// What sleeps until a component has something to do.
class Waker {
 public:
  /// Any thread; must not block.
  virtual void wake() = 0;

 protected:
  ~Waker() = default;
};

/// When a component runs next. The component asks through its protected functions; the runner
/// reads. Only `input_arrived` and `set_waker` may be called from another thread.
struct Schedule {
  std::atomic<bool> input_pending{false};  ///< one has come since the last tick began
  Time deadline = never;
  std::optional<PeriodicInstants> period;
  Time next_period = never;
  std::atomic<std::uint64_t> overruns{0};  ///< periods that were skipped: a tick came too late
  std::vector<int> descriptors;
  void input_arrived();
  /// `waker` is woken by the first input after each tick; null ends that, and waits for a call
  /// that is running. Between two wakers the component does not listen.
  void set_waker(Waker* waker);
  /// The next instant at which a tick is due without input.
  [[nodiscard]] Time due() const { return std::min(deadline, next_period); }
  /// Forgets what the tick at `now` answers to.
  void begin_tick(Time now);
  /// From the last tick on, or from the first one that comes.
  void repeat(const PeriodicInstants& wanted);

 private:
  Time begun_ = never;
  std::mutex waker_mutex_;
  std::atomic<Waker*> waker_{nullptr};
};

}  // namespace tocsin
