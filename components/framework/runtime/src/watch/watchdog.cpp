// SPDX-License-Identifier: Apache-2.0
#include "watch/watchdog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "watch/resident_memory.hpp"

namespace tocsin {
namespace {

/// Whether a thread that has not moved ought to have.
bool has_work(const ActivitySight& sight) {
  return sight.duty == Duty::announcements || sight.begun != sight.ended || sight.unread;
}

std::string text_of(const ActivitySight& sight, Duration still) {
  const double s = to_seconds(still);
  if (sight.duty == Duty::announcements) {
    return fmt::format("{} stands still: it has announced nothing for {:.1f} s", sight.name, s);
  }
  return sight.begun != sight.ended
             ? fmt::format("{} is stuck with one packet for {:.1f} s", sight.name, s)
             : fmt::format("{} is deaf: it has left packets unread for {:.1f} s", sight.name, s);
}

}  // namespace

Duration Watchdog::still(const ActivitySight& sight, Time now) {
  const auto [found, is_new] = last_.try_emplace(sight.id, Last{sight.begun, sight.ended, now});
  Last& last = found->second;
  const bool moved = last.begun != sight.begun || last.ended != sight.ended;
  if (moved || !has_work(sight)) last = {sight.begun, sight.ended, now};
  return is_new ? Duration::zero() : now - last.moved;
}

std::optional<WatchFinding> Watchdog::look(Time now, const std::vector<ActivitySight>& seen,
                                           std::uint64_t resident_bytes) {
  if (looked_ && now - *looked_ >= limits_.stuck) last_.clear();
  looked_ = now;
  if (resident_bytes > limits_.memory_bytes) {
    return WatchFinding{fmt::format("{:.0f} MiB resident, more than {:.0f}",
                                    static_cast<double>(resident_bytes) / mib,
                                    static_cast<double>(limits_.memory_bytes) / mib),
                        true};
  }
  for (auto it = last_.begin(); it != last_.end();) {
    const bool there = std::any_of(seen.begin(), seen.end(),
                                   [&](const auto& sight) { return sight.id == it->first; });
    it = there ? std::next(it) : last_.erase(it);
  }
  // Who holds a packet may hold the locks that others wait for: he is the one to name.
  std::optional<std::pair<bool, Duration>> worst;
  WatchFinding found{"", false};
  for (const ActivitySight& sight : seen) {
    const Duration since = still(sight, now);
    if (since < limits_.stuck) continue;
    found.is_final = found.is_final || since >= 2 * limits_.stuck;
    const std::pair rank{sight.begun != sight.ended, since};
    if (worst && *worst >= rank) continue;
    worst = rank;
    found.text = text_of(sight, since);
  }
  return worst ? std::optional(found) : std::nullopt;
}

}  // namespace tocsin
