// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/rtps_message.hpp"

#include <algorithm>
#include <array>

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

constexpr std::size_t entity_bytes = 4;
constexpr std::size_t prefix_bytes = 12;

// RTPS 2.2 section 9.4.5.1.1.
constexpr std::uint8_t pad = 0x01;
constexpr std::uint8_t acknack = 0x06;
constexpr std::uint8_t heartbeat = 0x07;
constexpr std::uint8_t info_timestamp = 0x09;
constexpr std::uint8_t info_destination = 0x0e;
constexpr std::uint8_t first_of_vendor = 0x80;

/// Where the sender's entity id stands in a submessage; nothing for kinds that name none.
std::optional<std::size_t> place_of_sender(std::uint8_t kind) {
  constexpr std::size_t first = 0;
  constexpr std::size_t second = 4;
  constexpr std::size_t in_data = 8;  // after extra flags, octets to inline QoS, reader
  switch (kind) {
    case 0x15:
    case 0x16:
      return in_data;  // DATA, DATA_FRAG
    case acknack:
    case 0x12:
      return first;  // ACKNACK, NACK_FRAG: from a reader
    case heartbeat:
    case 0x08:
    case 0x13:
      return second;  // HEARTBEAT, GAP, HEARTBEAT_FRAG
    default:
      return std::nullopt;
  }
}

std::optional<rtps::EntityId_t> sender_of(const Submessage& one) {
  const auto place = place_of_sender(one.kind);
  if (!place || *place + entity_bytes > one.bytes) return std::nullopt;
  rtps::EntityId_t endpoint;
  std::copy_n(one.content + *place, entity_bytes, endpoint.value);
  return endpoint;
}

}  // namespace

Submessages::Submessages(const std::uint8_t* message, std::size_t size)
    : at_(message + std::min(size, header_bytes)), end_(message + size) {}

std::optional<Submessage> Submessages::next() {
  const auto left = static_cast<std::size_t>(end_ - at_);
  if (left < submessage_header_bytes) return std::nullopt;
  const bool little_endian = (at_[1] & 1U) != 0;
  const std::size_t room = left - submessage_header_bytes;
  std::size_t bytes = number_at<std::uint16_t>(at_ + 2, little_endian);
  const bool may_be_empty = at_[0] == info_timestamp || at_[0] == pad;
  if (bytes == 0 && !may_be_empty) bytes = room;  // until the end of the message
  if (bytes > room) return std::nullopt;
  const Submessage one{at_[0], at_[1], at_ + submessage_header_bytes, bytes};
  at_ = one.content + one.bytes;
  return one;
}

std::optional<rtps::EntityId_t> sender_in(const std::uint8_t* message, std::size_t size) {
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (place_of_sender(one->kind)) return sender_of(*one);
  }
  return std::nullopt;
}

std::size_t size_without_statistics(const std::uint8_t* message, std::size_t size) {
  constexpr std::uint8_t statistics = 0x80;
  constexpr std::size_t statistics_bytes = 56;
  Submessages submessages(message, size);
  std::optional<Submessage> last;
  while (const auto next = submessages.next()) last = next;
  const bool ends_so = last && last->kind == statistics && last->bytes == statistics_bytes &&
                       last->content + last->bytes == message + size;
  return ends_so ? size - statistics_bytes - submessage_header_bytes : size;
}

bool is_announcement(const std::uint8_t* message, std::size_t size) {
  const auto sender = sender_in(message, size);
  return sender && *sender == rtps::c_EntityId_SPDPWriter;
}

namespace {

/// ENTITYID_P2P_BUILTIN_PARTICIPANT_STATELESS_WRITER.
const rtps::EntityId_t authentication_writer(0x000201c3);

/// The prefix of destination_participant_guid in a DATA with a ParticipantGenericMessage, behind
/// two message identities of 24 bytes; null where it cannot be found.
const std::uint8_t* addressee_in(const Submessage& one) {
  constexpr std::uint8_t inline_qos = 2;
  constexpr std::size_t offset_at = 2;
  constexpr std::size_t encapsulation_bytes = 4;
  constexpr std::size_t identities_bytes = 48;
  if ((one.flags & inline_qos) != 0 || one.bytes < offset_at + 2) return nullptr;
  const auto offset = number_at<std::uint16_t>(one.content + offset_at, (one.flags & 1U) != 0);
  const std::size_t at = offset_at + 2 + offset + encapsulation_bytes + identities_bytes;
  return at + prefix_bytes <= one.bytes ? one.content + at : nullptr;
}

}  // namespace

std::optional<Authentication> authentication_in(const std::uint8_t* message, std::size_t size) {
  const std::uint8_t* destination = nullptr;
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (one->kind == info_destination && one->bytes >= prefix_bytes) destination = one->content;
    const auto sender = sender_of(*one);
    if (!sender || *sender != authentication_writer) continue;
    const std::uint8_t* const addressee = addressee_in(*one);
    if (destination == nullptr || addressee == nullptr) return std::nullopt;
    Authentication found{{}, !std::equal(addressee, addressee + prefix_bytes, destination)};
    std::copy_n(addressee, prefix_bytes, found.addressee.value);
    return found;
  }
  return std::nullopt;
}

bool is_key_exchange(const std::uint8_t* message, std::size_t size) {
  constexpr std::uint8_t sec_prefix = 0x31;
  constexpr std::size_t key_at = 4;  // behind the kind of the transformation
  constexpr std::array<std::uint8_t, 4> zero{};
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (one->kind != sec_prefix || one->bytes < key_at + zero.size()) continue;
    return std::equal(zero.begin(), zero.end(), one->content + key_at);
  }
  return false;
}

bool is_builtin(const rtps::EntityId_t& endpoint) {
  constexpr rtps::octet builtin = 0xc0;
  return (endpoint.value[3] & builtin) == builtin;
}

std::optional<StateKey> discovery_state_in(const std::uint8_t* message, std::size_t size) {
  StateKey key{};
  bool found = false;
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (one->kind == info_timestamp || one->kind >= first_of_vendor) continue;
    if (one->kind == info_destination && !found && one->bytes >= prefix_bytes) {
      std::copy_n(one->content, prefix_bytes, key.begin() + 1);
      continue;
    }
    const auto sender = sender_of(*one);
    const bool is_state = one->kind == acknack || one->kind == heartbeat;
    if (found || !is_state || !sender || !is_builtin(*sender)) return std::nullopt;
    if (one->bytes < 2 * entity_bytes) return std::nullopt;
    key[0] = one->kind;
    std::copy_n(one->content, 2 * entity_bytes, key.begin() + 1 + prefix_bytes);
    found = true;
  }
  return found ? std::optional(key) : std::nullopt;
}

}  // namespace tocsin
