// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/discovery_keys.hpp"

#include <array>
#include <cstring>
#include <optional>

#include "link/rtps_message.hpp"

namespace tocsin {
namespace {

// RTPS 2.2 sections 9.4.5.3, 9.3.1.2, 9.6.2.2 and 10.
constexpr std::uint8_t data_kind = 0x15;
constexpr std::uint8_t little_flag = 0x01;
constexpr std::uint8_t inline_qos_flag = 0x02;
constexpr std::uint8_t data_flag = 0x04;
constexpr std::uint8_t key_flag = 0x08;
constexpr std::size_t octets_to_inline_qos_at = 2;
constexpr std::size_t data_writer_at = 8;
constexpr std::size_t parameter_header_bytes = 4;
constexpr std::size_t key_header_bytes = 4;
constexpr std::size_t guid_bytes = 16;
constexpr std::uint16_t pid_sentinel = 0x0001;
constexpr std::uint16_t pid_participant_guid = 0x0050;
constexpr std::uint16_t pid_endpoint_guid = 0x005a;
constexpr std::uint16_t pid_key_hash = 0x0070;
constexpr std::size_t added_bytes = parameter_header_bytes + guid_bytes;

/// Participants, writers and readers are announced by one writer each.
bool is_of_discovery(const std::uint8_t* writer) {
  constexpr std::array<std::array<std::uint8_t, 4>, 3> writers{
      {{0, 1, 0, 0xc2}, {0, 0, 3, 0xc2}, {0, 0, 4, 0xc2}}};
  for (const auto& one : writers) {
    if (std::memcmp(writer, one.data(), one.size()) == 0) return true;
  }
  return false;
}

/// Where the inline QoS of a DATA ends, before its sentinel; nothing when a key hash is among it,
/// or it is cut off.
std::optional<std::size_t> end_of_inline_qos(const Submessage& data, bool little) {
  std::size_t at = octets_to_inline_qos_at + sizeof(std::uint16_t) +
                   number_at<std::uint16_t>(data.content + octets_to_inline_qos_at, little);
  while (at + parameter_header_bytes <= data.bytes) {
    const auto id = number_at<std::uint16_t>(data.content + at, little);
    if (id == pid_sentinel) return at;
    if (id == pid_key_hash) return std::nullopt;
    at += parameter_header_bytes + number_at<std::uint16_t>(data.content + at + sizeof id, little);
  }
  return std::nullopt;
}

/// The GUID that a serialized key begins with; null when it does not.
const std::uint8_t* guid_in(const std::uint8_t* key, std::size_t bytes) {
  if (bytes < key_header_bytes + parameter_header_bytes + guid_bytes) return nullptr;
  const bool little = (key[1] & 1U) != 0;
  const std::uint8_t* const parameter = key + key_header_bytes;
  const auto id = number_at<std::uint16_t>(parameter, little);
  const bool is_guid = id == pid_participant_guid || id == pid_endpoint_guid;
  return is_guid && number_at<std::uint16_t>(parameter + sizeof id, little) == guid_bytes
             ? parameter + parameter_header_bytes
             : nullptr;
}

/// What is to be added to a message.
struct Addition {
  std::size_t at;             ///< in the message, and what follows moves on
  std::size_t submessage_at;  ///< whose length grows
  const std::uint8_t* guid;
  bool little;
};

std::optional<Addition> addition_to(const std::uint8_t* message, const Submessage& one) {
  constexpr std::uint8_t flags = inline_qos_flag | data_flag | key_flag;
  const bool ends = one.kind == data_kind && (one.flags & flags) == (inline_qos_flag | key_flag);
  constexpr std::size_t least = data_writer_at + 12;  // entity id and sequence number
  if (!ends || one.bytes < least || !is_of_discovery(one.content + data_writer_at))
    return std::nullopt;
  const bool little = (one.flags & little_flag) != 0;
  const auto end = end_of_inline_qos(one, little);
  if (!end) return std::nullopt;
  const std::size_t key = *end + parameter_header_bytes;
  const std::uint8_t* const guid = guid_in(one.content + key, one.bytes - key);
  if (guid == nullptr) return std::nullopt;
  const auto content = static_cast<std::size_t>(one.content - message);
  return Addition{content + *end, content - submessage_header_bytes, guid, little};
}

/// Adds it at the end of `changed`, which has been filled up to it. `moved`: by how much.
void add(const Addition& one, std::vector<std::uint8_t>& changed, std::size_t moved) {
  std::uint8_t* const length = changed.data() + one.submessage_at + moved + 2;
  const auto bytes = number_at<std::uint16_t>(length, one.little);
  // Zero reaches to the end of the message.
  if (bytes != 0) put_number(length, static_cast<std::uint16_t>(bytes + added_bytes), one.little);
  std::array<std::uint8_t, parameter_header_bytes> header{};
  put_number<std::uint16_t>(header.data(), pid_key_hash, one.little);
  put_number<std::uint16_t>(header.data() + 2, guid_bytes, one.little);
  changed.insert(changed.end(), header.begin(), header.end());
  changed.insert(changed.end(), one.guid, one.guid + guid_bytes);
}

}  // namespace

std::pair<const std::uint8_t*, std::size_t> with_discovery_keys(
    const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed) {
  changed.clear();
  std::size_t copied = 0;
  std::size_t moved = 0;
  Submessages all(message, size);
  while (const auto one = all.next()) {
    const auto addition = addition_to(message, *one);
    if (!addition) continue;
    changed.insert(changed.end(), message + copied, message + addition->at);
    add(*addition, changed, moved);
    copied = addition->at;
    moved += added_bytes;
  }
  if (moved == 0) return {message, size};
  changed.insert(changed.end(), message + copied, message + size);
  return {changed.data(), changed.size()};
}

}  // namespace tocsin
