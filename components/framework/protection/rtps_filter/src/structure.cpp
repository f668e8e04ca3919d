// SPDX-License-Identifier: Apache-2.0
#include "structure.hpp"

#include <algorithm>

#include "fragments.hpp"

namespace tocsin::rtps_filter {
namespace {

Wrong at_least(const Submessage& submessage, std::size_t bytes) {
  if (submessage.content.left() < bytes) return DropReason::submessage_length;
  return std::nullopt;
}

template <class Value>
Wrong wrong_of(const Checked<Value>& checked) {
  if (const auto* reason = std::get_if<DropReason>(&checked)) return *reason;
  return std::nullopt;
}

/// Encodings of RTPS 2.5 (table 10.3), of drafts of XTypes that are in use, and of vendors.
bool is_encoding(std::uint16_t id) { return id <= 0x001f || id >= 0x8000; }

Wrong check_payload(const Data& data) {
  constexpr std::size_t encapsulation_bytes = 4;
  if (!data.has_payload) return std::nullopt;
  const std::uint8_t* p = data.payload.here();
  if (data.payload.left() < encapsulation_bytes ||
      !is_encoding(static_cast<std::uint16_t>(p[0] << 8U | p[1]))) {
    return DropReason::payload;
  }
  return std::nullopt;
}

Wrong check_data(const Submessage& submessage, const Context& context) {
  const auto read = read_data(submessage);
  const auto* data = std::get_if<Data>(&read);
  if (data == nullptr) return wrong_of(read);
  switch (purpose_of(data->reader, data->writer)) {
    case Purpose::user_data:
      return check_payload(*data);
    case Purpose::participants:
    case Purpose::endpoints:
      return wrong_of(read_announcement(*data, context));
    case Purpose::liveliness:
      return check_liveliness(*data, context.header);
    case Purpose::authentication:
      return check_authentication(*data);
    case Purpose::confused:
      break;
  }
  return DropReason::discovery_payload;
}

/// What a fragment of an announcement says cannot be told before it is whole.
Wrong check_data_frag(const Submessage& submessage, const Limits& limits) {
  const auto read = read_data_frag(submessage, limits.sample_bytes);
  const auto* data = std::get_if<Data>(&read);
  if (data == nullptr) return wrong_of(read);
  const Purpose purpose = purpose_of(data->reader, data->writer);
  if (purpose == Purpose::user_data) return std::nullopt;
  if (purpose == Purpose::confused) return DropReason::discovery_payload;
  if (data->fragments.sample > most_announcement_bytes) return DropReason::sample_size;
  return std::nullopt;
}

Wrong check_gap(const Submessage& submessage, const Limits& limits) {
  const auto read = read_gap(submessage);
  const auto* gap = std::get_if<Gap>(&read);
  if (gap == nullptr) return wrong_of(read);
  if (gap->numbers > limits.gap_numbers) return DropReason::gap_range;
  return std::nullopt;
}

/// Only the sender itself may be named: nothing of ours is behind a gateway.
Wrong check_info_src(const Submessage& submessage, const Header& header) {
  constexpr std::size_t before_prefix = 4 + 2 + 2;
  Cursor at = submessage.content;
  at.skip(before_prefix);
  const Cursor prefix = at.part(header.prefix.size());
  if (!at.ok()) return DropReason::submessage_length;
  if (!std::equal(header.prefix.begin(), header.prefix.end(), prefix.here())) {
    return DropReason::foreign_identity;
  }
  return std::nullopt;
}

Wrong check_info_ts(const Submessage& submessage) {
  constexpr std::uint8_t invalidate = 1U << 1U;
  return (submessage.flags & invalidate) != 0 ? std::nullopt : at_least(submessage, 8);
}

/// Fast DDS puts it at a message's end, and asserts that it finds it there whole.
Wrong check_statistics(const Submessage& submessage, const Header& header) {
  constexpr std::size_t bytes = 56;  // locator, time stamp, sequence and sums of bytes
  if (header.vendor != vendor_eprosima) return std::nullopt;
  if (submessage.content.left() == bytes && submessage.last) return std::nullopt;
  return DropReason::vendor_submessage;
}

/// Headers and footers of the built-in cryptography (DDS Security 1.1, 9.5.3.3): what they must
/// have at least. A receiver without DDS Security ignores them.
Wrong check_seal(const Submessage& submessage) {
  constexpr std::size_t crypto_header = 20;
  constexpr std::size_t length_of_content = 4;
  constexpr std::size_t crypto_footer = 16 + 4;
  switch (submessage.kind) {
    case kind::sec_prefix:
    case kind::srtps_prefix:
      return at_least(submessage, crypto_header);
    case kind::sec_body:
      return at_least(submessage, length_of_content);
    default:
      return at_least(submessage, crypto_footer);
  }
}

Wrong check_numbers(const Submessage& submessage, const Limits& limits) {
  constexpr std::size_t heartbeat_frag_bytes = 4 + 4 + 8 + 4 + 4;
  switch (submessage.kind) {
    case kind::heartbeat:
      return wrong_of(read_heartbeat(submessage));
    case kind::gap:
      return check_gap(submessage, limits);
    case kind::acknack:
      return check_acknack(submessage);
    case kind::nack_frag:
      return check_nack_frag(submessage);
    default:
      return at_least(submessage, heartbeat_frag_bytes);
  }
}

Wrong check(const Submessage& submessage, const Context& context) {
  constexpr std::size_t prefix_bytes = 12;
  switch (submessage.kind) {
    case kind::data:
      return check_data(submessage, context);
    case kind::data_frag:
      return check_data_frag(submessage, context.limits);
    case kind::heartbeat:
    case kind::gap:
    case kind::acknack:
    case kind::nack_frag:
    case kind::heartbeat_frag:
      return check_numbers(submessage, context.limits);
    case kind::info_ts:
      return check_info_ts(submessage);
    case kind::info_dst:
      return at_least(submessage, prefix_bytes);
    case kind::info_src:
      return check_info_src(submessage, context.header);
    case kind::statistics:
      return check_statistics(submessage, context.header);
    case kind::sec_body:
    case kind::sec_prefix:
    case kind::sec_postfix:
    case kind::srtps_prefix:
    case kind::srtps_postfix:
      return check_seal(submessage);
    default:
      return std::nullopt;  // a receiver skips what it does not know (RTPS 2.5, 8.3.4.1)
  }
}

/// Builtin endpoints that DDS Security leaves without a seal (DDS Security 1.1, 7.4.3): those of
/// participants and of authentication. Those of discovery and liveliness for what is not protected
/// are there, and heartbeats of them harmless, but nothing of ours uses them.
bool is_open(std::uint32_t entity, bool sample) {
  switch (entity & ~std::uint32_t{7}) {
    case 0x000100c0:
    case 0x000201c0:
      return true;
    case 0x000003c0:
    case 0x000004c0:
    case 0x000200c0:
      return !sample;
    default:
      return false;
  }
}

/// Fast DDS 2.9.1 gives a protected endpoint what comes without a seal all the same.
Wrong check_unsealed(const Submessage& submessage) {
  Cursor at = submessage.content;
  bool sample = false;
  switch (submessage.kind) {
    case kind::data:
    case kind::data_frag:
      sample = true;
      at.skip(2 + 2);
      break;
    case kind::heartbeat:
    case kind::gap:
    case kind::acknack:
    case kind::nack_frag:
    case kind::heartbeat_frag:
      break;
    default:
      return std::nullopt;
  }
  const std::uint32_t reader = at.entity();
  const std::uint32_t writer = at.entity();
  const bool open = (reader == 0 || is_open(reader, sample)) && is_open(writer, sample);
  return open ? std::nullopt : Wrong(DropReason::unsealed);
}

/// DATA of discovery, fragments, and what tells numbers of a writer.
bool needs_memory(const Submessage& submessage) {
  if (submessage.kind == kind::heartbeat || submessage.kind == kind::gap) return true;
  const bool whole = submessage.kind == kind::data;
  if (!whole && submessage.kind != kind::data_frag) return false;
  Cursor at = submessage.content;
  at.skip(2 + 2);
  const std::uint32_t reader = at.entity();
  const Purpose purpose = purpose_of(reader, at.entity());
  if (!whole) return true;
  return purpose == Purpose::participants || purpose == Purpose::endpoints;
}

/// Whether a DATA tells that a participant leaves.
bool is_departure(const Data& data, const Context& context) {
  if (purpose_of(data.reader, data.writer) != Purpose::participants) return false;
  const auto read = read_announcement(data, context);
  const auto* const announcement = std::get_if<Announcement>(&read);
  return announcement != nullptr && announcement->leaves;
}

}  // namespace

Survey survey(const std::uint8_t* bytes, std::size_t size, const Header& header,
              const Limits& limits) {
  Survey found;
  Seals seals;
  Submessages submessages(bytes, size);
  while (const auto submessage = submessages.next()) {
    seals.pass(submessage->kind);
    found.wrong = check(*submessage, {header, limits, bytes, limits.secured && seals.sealed()});
    if (!found.wrong && limits.secured && !seals.sealed()) {
      found.wrong = check_unsealed(*submessage);
    }
    if (found.wrong) return found;
    found.needs_memory = found.needs_memory || needs_memory(*submessage);
  }
  if (submessages.wrong()) found.wrong = DropReason::submessage_length;
  return found;
}

bool says_goodbye(const std::uint8_t* bytes, std::size_t size, const Context& context) {
  bool leaves = false;
  Submessages submessages(bytes, size);
  while (const auto submessage = submessages.next()) {
    switch (submessage->kind) {
      case kind::pad:
      case kind::info_ts:
      case kind::info_dst:
      case kind::statistics:
        break;
      case kind::data:
        leaves = is_departure(std::get<Data>(read_data(*submessage)), context);
        if (!leaves) return false;
        break;
      default:
        return false;
    }
  }
  return leaves;
}

}  // namespace tocsin::rtps_filter
