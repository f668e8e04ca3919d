// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fast_dds_v2/repeat_times.hpp"
#include "foundation/time.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Sends the last packets of an exchange of keys again.
///
/// Keys go by ParticipantVolatileMessageSecure (DDS Security 1.1 section 7.4.4), each with a
/// heartbeat. The next heartbeat of Fast DDS 2.9.1 comes 3 s later, and no property changes that:
/// where the last packet is lost, or the last request for keys, peers join 3 s late. What was lost
/// before the last is asked for when the last arrives; what arrives twice is ignored. Pure; `now`
/// never decreases.
class KeyRepeats {
 public:
  /// Packets of so many bytes have keys; shorter ones are heartbeats and requests.
  static constexpr std::size_t least_key_bytes = 160;
  /// At the same time, of all peers; beyond that new ones are not repeated.
  static constexpr std::size_t most_packets = 16;

  struct Packet {
    std::vector<std::uint8_t> bytes;
    eprosima::fastdds::rtps::Locator_t to;
  };
  /// Takes the place of the last one of its kind to that address.
  void sent(Packet packet, Time now);
  [[nodiscard]] std::optional<Packet> take_due(Time now);
  /// When there will be one; `never` when none waits.
  [[nodiscard]] Time deadline() const;

 private:
  using Key = std::pair<eprosima::fastdds::rtps::Locator_t, bool>;  ///< whether it has keys
  struct Last {
    std::vector<std::uint8_t> bytes;
    RepeatTimes times;
  };
  std::map<Key, Last> last_;
};

}  // namespace tocsin
