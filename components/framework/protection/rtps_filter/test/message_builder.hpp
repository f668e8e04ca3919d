// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "rtps_filter/rtps_filter.hpp"

namespace tocsin::rtps_filter {

using Bytes = std::vector<std::uint8_t>;

inline const Time t0 = Time{} + std::chrono::hours(1);
inline constexpr Source alice{ipv4(127, 0, 0, 1), 40001};
inline constexpr Source mallory{ipv4(127, 0, 0, 1), 50001};
inline constexpr std::uint32_t user_writer = 0x00000103;
inline constexpr std::uint32_t spdp_writer = 0x000100c2;
inline constexpr std::uint32_t sedp_writer = 0x000003c2;

/// Appends little-endian numbers and texts.
class Wire {
 public:
  Wire& u8(std::uint32_t v) { return octet(v); }
  Wire& u16(std::uint32_t v) { return octet(v).octet(v >> 8U); }
  Wire& u32(std::uint32_t v) { return u16(v).u16(v >> 16U); }
  Wire& entity(std::uint32_t v) { return octet(v >> 24U).octet(v >> 16U).octet(v >> 8U).octet(v); }
  Wire& number(std::int64_t v) {
    const auto bits = static_cast<std::uint64_t>(v);
    return u32(static_cast<std::uint32_t>(bits >> 32U)).u32(static_cast<std::uint32_t>(bits));
  }
  Wire& raw(const Bytes& bytes) {
    for (const std::uint8_t byte : bytes) bytes_.push_back(byte);  // GCC 12 mistrusts insert
    return *this;
  }
  Wire& zeros(std::size_t count) { return raw(Bytes(count, 0)); }
  /// A CDR string, padded to four bytes.
  Wire& text(const std::string& text) {
    u32(static_cast<std::uint32_t>(text.size() + 1)).raw({text.begin(), text.end()}).u8(0);
    while (bytes_.size() % 4 != 0) u8(0);
    return *this;
  }
  /// A parameter of discovery or inline QoS.
  Wire& parameter(std::uint32_t id, const Bytes& value) {
    return u16(id).u16(static_cast<std::uint32_t>(value.size())).raw(value);
  }
  Wire& sentinel() { return u16(1).u16(0); }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  Wire& octet(std::uint32_t v) {
    bytes_.push_back(static_cast<std::uint8_t>(v));
    return *this;
  }
  Bytes bytes_;
};

/// The first twelve octets of a participant's GUIDs.
inline Bytes prefix_of(char name) { return Bytes(12, static_cast<std::uint8_t>(name)); }
inline Bytes guid_of(char name, std::uint32_t entity = 0x000001c1) {
  return Wire().raw(prefix_of(name)).entity(entity).bytes();
}

/// An RTPS message of the participant `name`.
class Message {
 public:
  explicit Message(char name = 'a', std::uint32_t vendor = 0x0103) {
    wire_.raw({'R', 'T', 'P', 'S', 2, 1}).u8(vendor >> 8U).u8(vendor).raw(prefix_of(name));
  }
  /// Little-endian; `flags` besides that one.
  Message& add(std::uint32_t kind, std::uint32_t flags, const Bytes& content) {
    wire_.u8(kind).u8(flags | 1U).u16(static_cast<std::uint32_t>(content.size())).raw(content);
    return *this;
  }
  /// With `length` in its header, whatever follows.
  Message& add_of_length(std::uint32_t kind, std::uint32_t length, const Bytes& content) {
    wire_.u8(kind).u8(1).u16(length).raw(content);
    return *this;
  }
  [[nodiscard]] const Bytes& bytes() const { return wire_.bytes(); }

 private:
  Wire wire_;
};

inline constexpr std::uint32_t with_qos = 2, with_data = 4, with_key = 8;

/// The content of a DATA before its inline QoS.
inline Wire data_head(std::uint32_t writer, std::int64_t number = 1, std::uint32_t octets = 16,
                      std::uint32_t reader = 0) {
  return Wire().u16(0).u16(octets).entity(reader).entity(writer).number(number);
}
/// A message of one DATA.
inline Bytes data_of(const Wire& content, std::uint32_t flags = with_data, char name = 'a') {
  return Message(name).add(0x15, flags, content.bytes()).bytes();
}
inline const Bytes& small_payload() {
  static const Bytes bytes = Wire().raw({0, 1, 0, 0}).u32(42).bytes();
  return bytes;
}
inline Bytes parameters_payload(const Wire& list) {
  return Wire().raw({0, 3, 0, 0}).raw(list.bytes()).bytes();
}
/// DATA(p) or DATA(w) of `name` with the parameters of `list`; its GUID and sentinel are added.
inline Bytes announcement(char name, const Wire& list = {}, std::uint32_t writer = spdp_writer,
                          std::uint32_t vendor = 0x0103) {
  const bool participant = writer == spdp_writer;
  const Wire all = Wire()
                       .parameter(participant ? 0x50 : 0x5a,
                                  guid_of(name, participant ? 0x000001c1 : user_writer))
                       .raw(list.bytes())
                       .sentinel();
  return Message(name, vendor)
      .add(0x15, with_data, data_head(writer).raw(parameters_payload(all)).bytes())
      .bytes();
}
/// The same of a participant that announces itself; `more` comes last.
inline Bytes announced(char name, std::uint32_t lease_s = 20, const Wire& more = {}) {
  return announcement(name, Wire()
                                .parameter(0x58, Wire().u32(0xc3f).bytes())
                                .parameter(0x02, Wire().u32(lease_s).u32(0).bytes())
                                .raw(more.bytes()));
}
/// DATA(p[UD]) that `speaker` sends about `leaver`.
inline Bytes departure(char speaker, char leaver) {
  const Wire qos = Wire().parameter(0x71, {0, 0, 0, 3}).parameter(0x70, guid_of(leaver)).sentinel();
  return Message(speaker)
      .add(0x15, with_qos, data_head(spdp_writer, 2).raw(qos.bytes()).bytes())
      .bytes();
}
inline Bytes heartbeat(char name, std::int64_t first, std::int64_t last,
                       std::uint32_t writer = user_writer) {
  return Message(name)
      .add(0x07, 0, Wire().entity(0).entity(writer).number(first).number(last).u32(1).bytes())
      .bytes();
}
inline Bytes gap(char name, std::int64_t start, std::int64_t base, std::uint32_t bits = 0,
                 std::uint32_t writer = user_writer) {
  const Wire content = Wire().entity(0).entity(writer).number(start).number(base).u32(bits);
  return Message(name)
      .add(0x08, 0, Wire(content).zeros(std::size_t{(bits + 31) / 32} * 4).bytes())
      .bytes();
}
inline Bytes locator(std::uint32_t address, std::uint32_t kind = 1) {
  return Wire().u32(kind).u32(7410).zeros(12).entity(address).bytes();
}

/// What a new filter, or `sut`, says of a packet.
inline Inspection inspect(RtpsFilter& sut, const Bytes& bytes, Source from = alice, Time now = t0) {
  return sut.inspect(bytes.data(), bytes.size(), from, now);
}
inline std::optional<DropReason> drop_of(RtpsFilter& sut, const Bytes& bytes, Source from = alice,
                                         Time now = t0) {
  return inspect(sut, bytes, from, now).drop;
}
inline std::optional<DropReason> drop_of(const Bytes& bytes) {
  RtpsFilter sut{Limits{}};
  return drop_of(sut, bytes);
}

/// What a new filter that knows the participant `a` says of a packet of `sender`.
inline std::optional<DropReason> drop_of(const Bytes& bytes, Sender sender) {
  RtpsFilter sut{Limits{}};
  (void)inspect(sut, announcement('a'));
  return sut.inspect(bytes.data(), bytes.size(), alice, t0, sender).drop;
}

inline constexpr std::nullopt_t passes = std::nullopt;

/// So that a failed comparison tells the reason's name.
inline void PrintTo(DropReason reason, std::ostream* to) { *to << to_text(reason); }

}  // namespace tocsin::rtps_filter
