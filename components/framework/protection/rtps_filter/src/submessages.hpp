// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "cursor.hpp"
#include "rtps_filter/drop_reason.hpp"

namespace tocsin::rtps_filter {

using Wrong = std::optional<DropReason>;
template <class Value>
using Checked = std::variant<Value, DropReason>;

/// Who speaks: the first twelve octets of all GUIDs of a participant.
using Prefix = std::array<std::uint8_t, 12>;
inline constexpr std::size_t header_bytes = 20;
inline constexpr std::size_t guid_bytes = 16;
inline constexpr std::uint16_t vendor_eprosima = 0x010f;

/// Kinds of submessages (RTPS 2.5, table 9.15; DDS Security 1.1, 7.3.6).
namespace kind {
inline constexpr std::uint8_t pad = 0x01, acknack = 0x06, heartbeat = 0x07, gap = 0x08,
                              info_ts = 0x09, info_src = 0x0c, info_reply_ip4 = 0x0d,
                              info_dst = 0x0e, info_reply = 0x0f, nack_frag = 0x12,
                              heartbeat_frag = 0x13, data = 0x15, data_frag = 0x16, sec_body = 0x30,
                              sec_prefix = 0x31, sec_postfix = 0x32, srtps_prefix = 0x33,
                              srtps_postfix = 0x34, statistics = 0x80;
}  // namespace kind

/// The header of a message.
struct Header {
  Prefix prefix;
  std::uint16_t vendor;
};
/// Nothing when the bytes are no RTPS message of version 2.
[[nodiscard]] std::optional<Header> read_header(const std::uint8_t* bytes, std::size_t size);

struct Submessage {
  std::uint8_t kind = 0;
  std::uint8_t flags = 0;
  bool last = false;
  Cursor content;  ///< what follows the submessage's header
};

/// Goes from one submessage to the next, as Fast DDS does: each begins at a multiple of four bytes.
class Submessages {
 public:
  Submessages(const std::uint8_t* bytes, std::size_t size)
      : at_(bytes + header_bytes, size - header_bytes, true) {}
  /// Nothing at the end, and where the next is longer than the message: `wrong()` tells.
  [[nodiscard]] std::optional<Submessage> next();
  [[nodiscard]] bool wrong() const { return wrong_; }

 private:
  Cursor at_;
  bool wrong_ = false;
};

/// DATA, or the part of a sample that DATA_FRAG carries.
struct Data {
  std::uint32_t reader = 0;  ///< entity ids
  std::uint32_t writer = 0;
  std::int64_t number = 0;
  Cursor inline_qos;  ///< its parameters, the sentinel included; empty when there are none
  Cursor payload;
  bool has_payload = false;  ///< serialized data, or a fragment
  bool has_key = false;      ///< a serialized key instead
  /// Of DATA_FRAG: its first fragment, counted from 1, how many it has, and the bytes of each but
  /// the sample's last, and of the sample.
  struct Fragments {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t size = 0;
    std::uint32_t sample = 0;
  } fragments;
};
[[nodiscard]] Checked<Data> read_data(const Submessage& submessage);
/// `sample_bytes`: the largest sample that is allowed.
[[nodiscard]] Checked<Data> read_data_frag(const Submessage& submessage,
                                           std::uint32_t sample_bytes);

struct Heartbeat {
  std::uint32_t reader = 0;  ///< entity ids
  std::uint32_t writer = 0;
  std::int64_t first = 0;
  std::uint32_t count = 0;
};
/// A sequence number, or a lease, as it stands on the wire: the high word first in either order.
[[nodiscard]] std::array<std::uint8_t, 8> number_bytes(std::int64_t number, bool little);
/// A HEARTBEAT's first and last number as they stand on the wire.
[[nodiscard]] std::array<std::uint8_t, 16> numbers_of(std::int64_t first, std::int64_t last,
                                                      bool little);
/// Where in its content a HEARTBEAT's first number stands, before its last.
inline constexpr std::size_t heartbeat_numbers_at = 4 + 4;
[[nodiscard]] Checked<Heartbeat> read_heartbeat(const Submessage& submessage);

struct Gap {
  std::uint32_t reader = 0;  ///< entity ids
  std::uint32_t writer = 0;
  std::int64_t start = 0;
  std::uint64_t numbers = 0;  ///< that are said to be irrelevant
  std::uint32_t bits = 0;     ///< the last of them, which may lie apart
};
[[nodiscard]] Checked<Gap> read_gap(const Submessage& submessage);

[[nodiscard]] Wrong check_acknack(const Submessage& submessage);
[[nodiscard]] Wrong check_nack_frag(const Submessage& submessage);

}  // namespace tocsin::rtps_filter
