// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "foundation/stop_value.hpp"
#include "foundation/time.hpp"

namespace tocsin::router {

/// The lock of a key: the first 16 bytes of its SHA-256 (FIPS 180-4). Nobody who knows the lock
/// alone can find the key, so that only who pressed a stop can release it.
[[nodiscard]] StopToken lock_of(const StopToken& key);

/// What a station says of the emergency stop on the link.
///
/// Each press has a fresh key. While the stop stands its lock is said; when it is released, its
/// key, for `released_said_for` and again whenever a vehicle reports that lock. Keys outlive the
/// process (memory, restore), so that a successor can release.
///
/// Pure: keys are drawn by `draw`; `now` must not decrease.
class StopSpeaker {
 public:
  struct Press {
    StopToken key{};
    bool released = false;
  };
  static constexpr std::size_t most_presses = 6;  ///< that are remembered
  static constexpr Duration released_said_for = std::chrono::seconds(5);
  /// After an "off" of a person all that this station has pressed is released, if its stop does not
  /// stand by then.
  static constexpr Duration release_lasts = std::chrono::seconds(2);

  explicit StopSpeaker(std::function<StopToken()> draw) : draw_(std::move(draw)) {}
  /// Presses of an earlier process. Those that were not released stand until a person releases.
  void restore(const std::vector<Press>& presses);
  [[nodiscard]] const std::vector<Press>& presses() const { return presses_; }

  /// Whether the host's own stop stands.
  void on_host(bool stands, Time now);
  /// A person has asked for the release.
  void on_release(Time now) { release_until_ = now + release_lasts; }
  /// Locks that a vehicle reports as standing.
  void on_report(const std::vector<StopToken>& locks, Time now);

  /// Fills in the locks and keys of what is said at `now`.
  void fill(StopValue& value, Time now) const;

 private:
  struct Said {
    StopToken key{};
    Time until{};
  };
  void release(Press& press, Time now);
  void say(const StopToken& key, Time until);

  std::function<StopToken()> draw_;
  std::vector<Press> presses_;  ///< oldest first
  std::vector<Said> said_;      ///< keys
  bool stands_ = false;
  Time release_until_ = Time::min();
};

}  // namespace tocsin::router
