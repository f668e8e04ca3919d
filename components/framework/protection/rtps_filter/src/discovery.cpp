// SPDX-License-Identifier: Apache-2.0
#include "discovery.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "parameters.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::size_t encapsulation_bytes = 4;

/// Purpose of a builtin endpoint; the least significant bits tell reader and writer apart.
Purpose purpose_of_builtin(std::uint32_t entity) {
  switch (entity & ~std::uint32_t{7}) {
    case 0x000100c0:
    case 0xff0101c0:
      return Purpose::participants;
    case 0x000003c0:
    case 0x000004c0:
    case 0xff0003c0:
    case 0xff0004c0:
      return Purpose::endpoints;
    case 0x000200c0:
    case 0xff0200c0:
      return Purpose::liveliness;
    case 0x000201c0:
    case 0xff0202c0:
      return Purpose::authentication;
    default:
      return Purpose::user_data;
  }
}

bool is_of(const Prefix& prefix, const std::uint8_t* guid) {
  return std::equal(prefix.begin(), prefix.end(), guid);
}

/// Notes whose announcement it is; false when that is another than the sender's participant.
bool note_guid(const Cursor& value, const Prefix& sender, Announcement& announcement) {
  if (value.left() < guid_bytes || !is_of(sender, value.here())) return false;
  announcement.guid.emplace();
  std::copy_n(value.here(), guid_bytes, announcement.guid->begin());
  return true;
}

/// Whether an inline QoS says that the instance is disposed or unregistered (RTPS 2.5, 9.6.4.9).
bool leaves(const Cursor& inline_qos) {
  Parameters parameters(inline_qos);
  while (const auto parameter = parameters.next()) {
    if (parameter->id != pid::status_info) continue;
    const std::uint8_t status = parameter->value.here()[3];
    if (status >= 1 && status <= 3) return true;
  }
  return false;
}

Wrong note_keys(const Cursor& inline_qos, const Prefix& sender, Announcement& announcement) {
  Parameters parameters(inline_qos);
  while (const auto parameter = parameters.next()) {
    if (parameter->id != pid::key_hash) continue;
    if (!note_guid(parameter->value, sender, announcement)) return DropReason::foreign_identity;
  }
  return std::nullopt;
}

bool is_locator(std::uint16_t id) {
  return id == pid::unicast_locator || id == pid::multicast_locator ||
         id == pid::default_unicast_locator || id == pid::default_multicast_locator ||
         id == pid::metatraffic_unicast_locator || id == pid::metatraffic_multicast_locator;
}

/// Whether a locator names an IPv4 address that the configuration does not know.
bool is_unknown(Cursor locator, const Limits& limits) {
  constexpr std::uint32_t udp_v4 = 1;
  if (!limits.answers || locator.u32() != udp_v4) return false;
  locator.skip(4 + 12);  // port, and what an IPv4 address leaves free
  const std::uint8_t* a = locator.here();
  return !limits.answers(ipv4(a[0], a[1], a[2], a[3]));
}

bool must_strip(const Parameter& parameter, const Context& context) {
  switch (parameter.id) {
    case pid::type_id:
    case pid::type_object:
    case pid::type_information:
      return context.limits.strip_type_information;
    case pid::data_sharing:
      return context.header.vendor != vendor_eprosima;  // Fast DDS reads it as its own
    default:
      return is_locator(parameter.id) && is_unknown(parameter.value, context.limits);
  }
}

Duration lease_of(Cursor value) {
  constexpr double fractions_per_s = 4294967296.0;
  const double whole = static_cast<std::int32_t>(value.u32());
  return seconds(whole + static_cast<double>(value.u32()) / fractions_per_s);
}

/// What a participant says of itself, besides who it is.
void note_property(const Parameter& parameter, const Context& context, Announcement& announcement) {
  Cursor value = parameter.value;
  if (parameter.id == pid::builtin_endpoints) announcement.has_announcer = (value.u32() & 1U) != 0;
  if (parameter.id == pid::user_data) {
    const Cursor octets = value.part(value.u32());
    announcement.user_data = {reinterpret_cast<const char*>(octets.here()), octets.left()};
  }
  if (parameter.id != pid::lease) return;
  announcement.lease = lease_of(parameter.value);
  announcement.lease_at = {static_cast<std::size_t>(value.here() - context.packet), value.little()};
  const Duration longest = context.limits.longest_lease;
  if (longest > Duration{} && !context.sealed) {
    announcement.lease = std::min(announcement.lease, longest);
  }
}

/// One parameter of an announcement: its form, whose it is, and whether it may be read.
Wrong note_parameter(const Parameter& parameter, const Context& context,
                     Announcement& announcement) {
  const bool stripped = !context.sealed && must_strip(parameter, context);
  if (stripped) {
    announcement.strip.push_back(static_cast<std::size_t>(parameter.place - context.packet));
    return std::nullopt;
  }
  if (const Wrong wrong = check_parameter(parameter)) return wrong;
  note_property(parameter, context, announcement);
  const bool names_somebody = parameter.id == pid::participant_guid ||
                              parameter.id == pid::endpoint_guid || parameter.id == pid::key_hash;
  if (!names_somebody) return std::nullopt;
  if (!is_of(context.header.prefix, parameter.value.here())) return DropReason::foreign_identity;
  // An endpoint's announcement may name its participant, too.
  if (parameter.id != pid::participant_guid || !announcement.guid) {
    (void)note_guid(parameter.value, context.header.prefix, announcement);
  }
  return std::nullopt;
}

/// A locator that is too short to be looked at is told apart before.
Wrong check_locator_sizes(Cursor list) {
  Parameters parameters(list);
  while (const auto parameter = parameters.next()) {
    if (!is_locator(parameter->id)) continue;
    if (const Wrong wrong = check_parameter(*parameter)) return wrong;
  }
  return std::nullopt;
}

Wrong note_list(Cursor payload, const Context& context, Announcement& announcement) {
  constexpr std::uint8_t pl_cdr_be = 2;
  constexpr std::uint8_t pl_cdr_le = 3;
  const std::uint8_t encoding = payload.here()[1];  // all that Fast DDS looks at
  if (encoding != pl_cdr_be && encoding != pl_cdr_le) return std::nullopt;  // which it cannot read
  payload.skip(encapsulation_bytes);
  Cursor list(payload.here(), payload.left(), encoding == pl_cdr_le);
  if (!bytes_of_list(list)) return DropReason::parameter_length;
  if (const Wrong wrong = check_locator_sizes(list)) return wrong;
  Parameters parameters(list);
  while (const auto parameter = parameters.next()) {
    if (const Wrong wrong = note_parameter(*parameter, context, announcement)) return wrong;
  }
  return std::nullopt;
}

/// Automatic, or manual by participant (RTPS 2.5, 9.6.2.2.4 names no other).
bool is_liveliness_kind(const std::uint8_t* kind) {
  return kind[0] == 0 && kind[1] == 0 && kind[2] == 0 && kind[3] <= 2;
}

}  // namespace

std::array<std::uint8_t, 8> lease_bytes(Duration lease, bool little) {
  constexpr double fractions_per_s = 4294967296.0;
  const double whole = std::floor(to_seconds(lease));
  const auto fraction = static_cast<std::uint32_t>((to_seconds(lease) - whole) * fractions_per_s);
  return number_bytes(static_cast<std::int64_t>(std::uint64_t(whole) << 32U | fraction), little);
}

Purpose purpose_of(std::uint32_t reader, std::uint32_t writer) {
  const Purpose of_writer = purpose_of_builtin(writer);
  const Purpose of_reader = purpose_of_builtin(reader);
  if (of_writer == of_reader || reader == 0) return of_writer;
  return Purpose::confused;
}

Checked<Announcement> read_announcement(const Data& data, const Context& context) {
  constexpr int default_lease_s = 100;  // RTPS 2.5, table 9.18
  Announcement announcement;
  announcement.lease = std::chrono::seconds(default_lease_s);
  announcement.number = data.number;
  announcement.content = data.payload;
  announcement.leaves = leaves(data.inline_qos);
  if (const Wrong wrong = note_keys(data.inline_qos, context.header.prefix, announcement)) {
    return *wrong;
  }
  if (!announcement.leaves && !data.has_payload) return DropReason::discovery_payload;
  if (!data.has_payload && !data.has_key) return announcement;
  if (data.payload.left() < encapsulation_bytes) return DropReason::discovery_payload;
  // Fast DDS takes a serialized key of up to 16 bytes for a key hash.
  if (data.has_key && data.payload.left() <= guid_bytes) {
    if (!note_guid(data.payload, context.header.prefix, announcement)) {
      return DropReason::foreign_identity;
    }
    return announcement;
  }
  if (const Wrong wrong = note_list(data.payload, context, announcement)) return *wrong;
  return announcement;
}

Wrong check_liveliness(const Data& data, const Header& header) {
  constexpr std::size_t key_bytes = 16;  // prefix and kind
  constexpr std::size_t most_bytes = 512;
  Announcement about;
  if (const Wrong wrong = note_keys(data.inline_qos, header.prefix, about)) return wrong;
  // Fast DDS keeps a sample for each kind.
  if (about.guid && !is_liveliness_kind(about.guid->data() + header.prefix.size())) {
    return DropReason::discovery_payload;
  }
  if (data.payload.left() > most_bytes) return DropReason::discovery_payload;
  if (!data.has_payload) return std::nullopt;
  if (data.payload.left() < encapsulation_bytes + key_bytes) return DropReason::discovery_payload;
  const std::uint8_t* const key = data.payload.here() + encapsulation_bytes;
  if (!is_of(header.prefix, key)) return DropReason::foreign_identity;
  if (!is_liveliness_kind(key + header.prefix.size())) return DropReason::discovery_payload;
  return std::nullopt;
}

Wrong check_authentication(const Data& data) {
  constexpr std::size_t identity_bytes = guid_bytes + 8;  // writer and sequence number
  if (!data.has_payload) return std::nullopt;
  Cursor at = data.payload;
  if (at.left() < encapsulation_bytes) return DropReason::security_content;
  Cursor content(at.here() + encapsulation_bytes, at.left() - encapsulation_bytes,
                 (at.here()[1] & 1U) != 0);
  content.skip(2 * identity_bytes + 3 * guid_bytes);  // of the message, its cause, who to whom
  Cursor text = content.part(content.left());
  if (!content.ok() || !is_message_data(text)) return DropReason::security_content;
  return std::nullopt;
}

}  // namespace tocsin::rtps_filter
