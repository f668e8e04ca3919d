// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "fast_dds_v2/repeat_times.hpp"
#include "foundation/time.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Sends messages of authentication again until their addressee answers.
///
/// Such a message has 4 kB, which go in four pieces, and nothing of DDS repairs it: where 30 % of
/// the packets are lost one of four arrives, and Fast DDS 2.9.1 can end with two participants of
/// which one takes the other for authenticated. A message of the addressee with a number that it
/// has not used before is its answer. Pure; any thread; `now` never decreases.
class AuthenticationRepeats {
 public:
  using Participant = eprosima::fastdds::rtps::GuidPrefix_t;
  using Packet = std::vector<std::uint8_t>;
  /// At the same time; beyond that the oldest are not repeated any more.
  static constexpr std::size_t most_messages = 8;

  struct Due {
    std::vector<Packet> packets;
    eprosima::fastdds::rtps::Locator_t to;
  };
  void sent(const Participant& addressee, Due message, Time now);
  /// Any packet that has arrived.
  void on_packet(const std::uint8_t* bytes, std::size_t size);
  [[nodiscard]] std::optional<Due> take_due(Time now);
  /// When there will be one; `never` when none waits.
  [[nodiscard]] Time deadline() const;

 private:
  struct Message {
    Participant addressee;
    Due content;
    RepeatTimes times;
  };
  mutable std::mutex mutex_;
  std::list<Message> messages_;                ///< the oldest first
  std::map<Participant, std::uint32_t> last_;  ///< number that a participant has used last
};

}  // namespace tocsin
