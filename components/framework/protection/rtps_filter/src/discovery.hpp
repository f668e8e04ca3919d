// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "foundation/time.hpp"
#include "rtps_filter/limits.hpp"
#include "rtps_filter/source.hpp"
#include "submessages.hpp"

namespace tocsin::rtps_filter {

/// What the endpoints of a submessage are for, by their entity ids (RTPS 2.5, table 9.3; DDS
/// Security 1.1, table 8).
enum class Purpose {
  user_data,       ///< or something that Fast DDS has no reader for
  participants,    ///< SPDP
  endpoints,       ///< SEDP
  liveliness,      ///< ParticipantMessageData
  authentication,  ///< ParticipantGenericMessage
  confused,        ///< a reader of one with the writer of another
};
[[nodiscard]] Purpose purpose_of(std::uint32_t reader, std::uint32_t writer);

/// Sender and surroundings of a submessage.
struct Context {
  const Header& header;
  const Limits& limits;
  const std::uint8_t* packet;
  bool sealed;  ///< what it says must not be changed
};

/// A participant or an endpoint comes, goes on, or leaves.
struct Announcement {
  bool leaves = false;
  std::optional<std::array<std::uint8_t, 16>> guid;  ///< of whom; begins with the sender's prefix
  Duration lease{};  ///< of a participant; the standard's default where it says none
  /// Where in the packet its lease stands; nothing where it says none.
  struct LeasePlace {
    std::size_t at;
    bool little;  ///< its byte order
  };
  std::optional<LeasePlace> lease_at;
  std::string_view user_data;      ///< in the packet
  bool has_announcer = false;      ///< its builtin endpoints include the one that announces it
  std::int64_t number = 0;         ///< of the sample
  Cursor content;                  ///< the payload as it was sent
  std::vector<std::size_t> strip;  ///< see Inspection
};
/// A lease as it stands on the wire.
[[nodiscard]] std::array<std::uint8_t, 8> lease_bytes(Duration lease, bool little);
/// What a DATA of `participants` or `endpoints` tells. The reason when it is no such thing.
[[nodiscard]] Checked<Announcement> read_announcement(const Data& data, const Context& context);

[[nodiscard]] Wrong check_liveliness(const Data& data, const Header& header);
[[nodiscard]] Wrong check_authentication(const Data& data);

}  // namespace tocsin::rtps_filter
