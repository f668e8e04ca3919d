// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "foundation/stop_value.hpp"
#include "foundation/time.hpp"
#include "link_router/freeze_watch.hpp"

namespace tocsin::router {

/// Which emergency stops of stations stand on a vehicle.
///
/// - Whoever says that a stop stands presses it. On a secured link only signed values get here.
/// - A stop ends by the key of its lock. On a secured link it also ends when the identity that
/// pressed
///   it says in a newer value that none stands. A person at the vehicle ends those of stations that
///   are not received any more (release_left).
/// - A router whose packets are received, but no fresh value for `fresh_for`, counts as a stop
/// until
///   a value of that host is received.
/// - Nothing else is remembered of a peer: neither streams nor order nor discovery.
///
/// Pure; `now` must not decrease.
class StopListener {
 public:
  static constexpr Duration fresh_for = std::chrono::seconds(1);
  /// A station is received when it has said something within this time.
  static constexpr Duration received_for = std::chrono::seconds(2);
  static constexpr std::size_t most_stops = 64;

  void on_value(const ReceivedStop& received);
  void on_packet(const ReceivedPacket& packet);
  /// What time alone changes. Call it before one of the questions below.
  void follow(Time now);
  /// A person at the vehicle.
  void release_left(Time now);

  [[nodiscard]] bool stands() const;
  /// Whether `stands` is more than what was so before a start or a freeze: a stop stands, a value
  /// was received since, or none for `fresh_for`.
  [[nodiscard]] bool knows(Time now) const;
  /// Names of those whose stops stand; not empty while one does.
  [[nodiscard]] std::vector<std::string> stopped_by() const;
  /// The first of the locks that stand, for a report.
  [[nodiscard]] std::vector<StopToken> locks() const;
  /// Since the last fresh value of any station; nothing: there was none.
  [[nodiscard]] std::optional<Duration> silence(Time now) const;
  /// Rises with each release_left, and each release by an identity.
  [[nodiscard]] std::uint64_t releases() const { return releases_; }

  /// What a successor of this process goes on with.
  struct Memory {
    std::vector<StopToken> locks;
    bool more = false;  ///< stops whose locks are not known
  };
  [[nodiscard]] Memory memory() const;
  void restore(const Memory& memory, Time now);

 private:
  struct Stop {
    StopToken lock{};
    std::string identity;
    std::uint64_t number = 0;  ///< of the value that said it last
    std::vector<std::string> by;
    Time said{};
  };
  /// A router of a station.
  struct Station {
    std::string host;
    Time value{};
    Time packet{};
  };
  void press(const ReceivedStop& received);
  void try_keys(const std::vector<StopToken>& keys);
  void release_by_identity(const ReceivedStop& received);
  [[nodiscard]] bool is_fresh(const ReceivedStop& received);

  std::vector<Stop> stops_;
  bool more_ = false;                             ///< beyond most_stops
  std::map<std::uint64_t, Station> stations_;     ///< by router
  std::map<std::string, std::uint64_t> numbers_;  ///< highest, by identity
  std::vector<std::string> stale_;                ///< hosts whose value is not fresh
  std::optional<Time> last_value_;
  FreezeWatch watch_;
  Time begun_{};  ///< of its instance, or after its last freeze
  std::uint64_t releases_ = 0;
};

}  // namespace tocsin::router
