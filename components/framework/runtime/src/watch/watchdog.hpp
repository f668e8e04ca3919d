// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "watch/activity.hpp"

namespace tocsin {

/// One activity at one instant.
struct ActivitySight {
  const void* id;  ///< tells it from others for as long as it is there
  Duty duty;
  std::string name;
  std::uint64_t begun;
  std::uint64_t ended;
  bool unread;  ///< bytes wait in its socket
};

struct WatchLimits {
  Duration stuck;              ///< without a sign of life that long: a finding; twice: the end
  std::uint64_t memory_bytes;  ///< more resident memory: the end
};

/// What is wrong with this process.
struct WatchFinding {
  std::string text;
  bool is_final;  ///< it will not mend itself: the process is to end, and to be started again
};

/// Judges whether the threads of DDS in this process do their work, and its memory. Pure.
///
/// A reception stands still when it has one packet in its hands, or leaves packets in its socket,
/// and takes no other; a timer, when it announces nothing. A process that was itself stopped
/// (SIGSTOP, a computer asleep) is given its time anew.
class Watchdog {
 public:
  explicit Watchdog(const WatchLimits& limits) : limits_(limits) {}
  /// `now` must not decrease. To be called several times within `stuck`.
  [[nodiscard]] std::optional<WatchFinding> look(Time now, const std::vector<ActivitySight>& seen,
                                                 std::uint64_t resident_bytes);

 private:
  struct Last {
    std::uint64_t begun;
    std::uint64_t ended;
    Time moved;
  };
  [[nodiscard]] Duration still(const ActivitySight& sight, Time now);

  const WatchLimits limits_;
  std::optional<Time> looked_;
  std::map<const void*, Last> last_;
};

}  // namespace tocsin
