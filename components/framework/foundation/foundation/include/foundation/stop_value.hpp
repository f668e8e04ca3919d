// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/time.hpp"

namespace tocsin {

/// Names a stop that stands (its lock), or ends it (the key of that lock).
using StopToken = std::array<std::uint8_t, 16>;

/// What the packets of a host's router say of the emergency stop. It rides in every packet that has
/// room for it, and in one of its own ten times a second, so that who receives it needs no stream,
/// no history and no discovery.
///
/// A station presses by a lock, and releases by the key of it: the lock is a hash of the key, so
/// that nobody else can release. A vehicle reports the locks that stand.
struct StopValue {
  static constexpr std::size_t most_tokens = 4;
  static constexpr std::size_t most_names = 4;
  static constexpr std::size_t longest_name = 40;  ///< [byte] of a host or a presser; cut beyond it

  Role role = Role::gcs;           ///< of the host that says it
  std::string host;                ///< its name
  std::uint64_t instance = 0;      ///< of its router; a restart has another
  std::uint64_t number = 0;        ///< larger in each value, also over restarts: [us] of wall time
  bool known = true;               ///< false: a vehicle that does not know whether it stands
  bool stands = false;             ///< a station: pressed; a vehicle: stands by an emergency stop
  std::int64_t since_wall_ns = 0;  ///< [ns] since the Unix epoch, when `stands` became so
  std::vector<StopToken> locks{};  ///< at most most_tokens
  std::vector<StopToken> keys{};   ///< at most most_tokens
  std::vector<std::string> by{};   ///< who presses; at most most_names
  std::string site{};  ///< a vehicle that has several: the host of the one it speaks with
};
[[nodiscard]] inline bool operator==(const StopValue& one, const StopValue& other) {
  const auto all = [](const StopValue& value) {
    return std::tie(value.role, value.host, value.instance, value.number, value.known, value.stands,
                    value.since_wall_ns, value.locks, value.keys, value.by, value.site);
  };
  return all(one) == all(other);
}
/// Whether they differ in their number and time alone.
[[nodiscard]] inline bool says_the_same(const StopValue& one, StopValue other) {
  other.number = one.number;
  other.since_wall_ns = one.since_wall_ns;
  return one == other;
}

/// Said once, a value is sent for so long: a router that has stopped deciding falls silent.
inline constexpr Duration stop_value_lives = std::chrono::milliseconds(500);
/// Without other packets to ride in it is sent alone, so often.
inline constexpr Duration stop_value_period = std::chrono::milliseconds(100);

/// A value as it was received.
struct ReceivedStop {
  StopValue value;
  std::uint64_t router = 0;  ///< the participant in whose packet it was
  /// Of a secured link: the certificate's subject of who signed it. Empty on a plain link.
  std::string identity;
  Time received{};
};
/// When a packet of a router was last received, with a value or without.
struct ReceivedPacket {
  std::uint64_t router = 0;
  Time received{};
};
/// What was received since one looked last.
struct StopNews {
  std::vector<ReceivedStop> values;
  std::vector<ReceivedPacket> packets;
};

}  // namespace tocsin
