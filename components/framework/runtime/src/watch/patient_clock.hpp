// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <optional>

#include "foundation/time.hpp"

namespace tocsin {

/// How long each thread of a process has waited for a processor since it began, by its id [ns].
using ProcessorWaits = std::map<int, std::uint64_t>;

/// The second number of a `schedstat` (proc(5), Linux's sched-stats.rst): time on a run queue [ns].
/// Empty when it is not there.
[[nodiscard]] std::optional<std::uint64_t> processor_wait(std::istream& schedstat);

/// Of this process's threads; empty where the kernel does not say it. Any thread.
[[nodiscard]] ProcessorWaits processor_waits();

/// A clock that goes slower while a thread is ready to run and gets no processor: who has no time
/// to work does not stand still. Ten times slower at most, so that a thread that spins and takes
/// the others' time is found all the same. Pure.
class PatientClock {
 public:
  static constexpr double most_patience = 0.9;  ///< [1] share of a time that is not counted

  /// `now` must not decrease; neither does what comes of it.
  [[nodiscard]] Time at(Time now, const ProcessorWaits& waits);

 private:
  std::optional<Time> last_;
  ProcessorWaits waits_;
  Duration uncounted_{0};
};

}  // namespace tocsin
