// SPDX-License-Identifier: Apache-2.0
#include "watch/patient_clock.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace tocsin {

std::optional<std::uint64_t> processor_wait(std::istream& schedstat) {
  std::uint64_t ran_ns = 0;
  std::uint64_t waited_ns = 0;
  if (!(schedstat >> ran_ns >> waited_ns)) return std::nullopt;
  return waited_ns;
}

ProcessorWaits processor_waits() {
  ProcessorWaits waits;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", error)) {
    std::ifstream file(entry.path() / "schedstat");
    const auto waited = processor_wait(file);
    if (waited) waits[std::atoi(entry.path().filename().c_str())] = *waited;
  }
  return waits;
}

Time PatientClock::at(Time now, const ProcessorWaits& waits) {
  std::uint64_t longest_ns = 0;
  for (const auto& [thread, waited_ns] : waits) {
    const auto before = waits_.find(thread);
    // A thread that is new, or has an id that another had.
    const std::uint64_t since = before == waits_.end() || before->second > waited_ns
                                    ? waited_ns
                                    : waited_ns - before->second;
    longest_ns = std::max(longest_ns, since);
  }
  if (last_) {
    const Duration passed = now - *last_;
    const Duration most = std::chrono::duration_cast<Duration>(passed * most_patience);
    uncounted_ += std::min<Duration>(most, std::chrono::nanoseconds(longest_ns));
  }
  last_ = now;
  waits_ = waits;
  return now - uncounted_;
}

}  // namespace tocsin
