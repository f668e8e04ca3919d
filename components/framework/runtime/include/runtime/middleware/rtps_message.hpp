// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// RTPS 2.2 sections 9.4.4 and 9.4.5.1: of a message, and of each submessage.
constexpr std::size_t header_bytes = 20;
constexpr std::size_t submessage_header_bytes = 4;

/// An unsigned number as RTPS messages hold it: in the byte order of its submessage.
template <class Number>
[[nodiscard]] Number number_at(const std::uint8_t* at, bool little_endian) {
  Number value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    const std::size_t place = little_endian ? i : sizeof value - 1 - i;
    value = static_cast<Number>(value | static_cast<Number>(at[i]) << 8U * place);
  }
  return value;
}
template <class Number>
void put_number(std::uint8_t* at, Number value, bool little_endian) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    at[i] = static_cast<std::uint8_t>(value >> 8U * (little_endian ? i : sizeof value - 1 - i));
  }
}

/// One submessage, without its header of four bytes.
struct Submessage {
  std::uint8_t kind = 0;
  std::uint8_t flags = 0;  ///< bit 0: little endian
  const std::uint8_t* content = nullptr;
  std::size_t bytes = 0;
};

/// Walks over the submessages of an RTPS message (RTPS 2.2 section 9.4.5.1), whatever its bytes.
/// Ends before one that says to be longer than the message.
class Submessages {
 public:
  /// The bytes must outlive this.
  Submessages(const std::uint8_t* message, std::size_t size);
  [[nodiscard]] std::optional<Submessage> next();

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

/// The endpoint that an RTPS message comes from: the writer of its first DATA, HEARTBEAT or GAP,
/// the reader of its first ACKNACK (RTPS 2.2 section 8.3.7). Nothing when there is none, or the
/// bytes are no such message.
[[nodiscard]] std::optional<eprosima::fastdds::rtps::EntityId_t> sender_in(
    const std::uint8_t* message, std::size_t size);

/// The size of a message without the submessage that Fast DDS 2.9.1 ends each message with when it
/// is built with statistics, as Debian's is: 60 bytes that say nothing to a peer of ours.
[[nodiscard]] std::size_t size_without_statistics(const std::uint8_t* message, std::size_t size);

/// Whether it is one of those by which participants discover each other (section 9.3.1.2).
[[nodiscard]] bool is_builtin(const eprosima::fastdds::rtps::EntityId_t& endpoint);

/// Whether a message announces its participant (section 8.5.3).
[[nodiscard]] bool is_announcement(const std::uint8_t* message, std::size_t size);

/// Whom a message of authentication is for (DDS Security 1.1 sections 7.4.3.5 and 7.4.4.3).
struct Authentication {
  eprosima::fastdds::rtps::GuidPrefix_t addressee;
  /// Whether the packet is for another participant. Fast DDS 2.9.1 sends each to every participant
  /// that it knows; who is not the addressee throws it away.
  bool goes_elsewhere;
};
/// Nothing when it is none, or does not say.
[[nodiscard]] std::optional<Authentication> authentication_in(const std::uint8_t* message,
                                                              std::size_t size);

/// Whether a message is part of an exchange of keys: a submessage in it is sealed with the key of
/// the handshake, whose identifier is zero (DDS Security 1.1 sections 9.5.2.1.2 and 9.5.2.3).
[[nodiscard]] bool is_key_exchange(const std::uint8_t* message, std::size_t size);

/// Whose state a message tells: HEARTBEAT or ACKNACK, the participant that it is for, reader and
/// writer.
using StateKey = std::array<std::uint8_t, 21>;

/// The key of a message that holds one heartbeat or acknowledgement of discovery, and nothing else:
/// the next message with this key makes it obsolete.
[[nodiscard]] std::optional<StateKey> discovery_state_in(const std::uint8_t* message,
                                                         std::size_t size);

}  // namespace tocsin
