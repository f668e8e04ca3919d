// SPDX-License-Identifier: Apache-2.0
#include "announcement_copy.hpp"

#include <algorithm>

#include "parameters.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::size_t submessage_header = 4;
constexpr std::size_t before_number = 2 + 2 + 4 + 4;  // flags, offset, reader, writer
constexpr std::uint8_t little = 1;

template <std::size_t size>
void put(Octets& message, std::size_t at, const std::array<std::uint8_t, size>& bytes) {
  std::copy(bytes.begin(), bytes.end(), message.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace

std::size_t number_place(const Submessage& submessage, const std::uint8_t* packet) {
  return static_cast<std::size_t>(submessage.content.here() - packet) + before_number;
}

AnnouncementCopy::AnnouncementCopy(const Submessage& submessage, const Announcement& what,
                                   const Context& context, const Inspection& edits)
    : message_(context.packet, context.packet + header_bytes) {
  const std::uint8_t* const begin = submessage.content.here() - submessage_header;
  const std::size_t size = submessage_header + submessage.content.left();
  message_.insert(message_.end(), begin, begin + size);
  message_[header_bytes + 2] = message_[header_bytes + 3] = 0;  // until the end of the message
  const auto from = static_cast<std::size_t>(begin - context.packet);
  const auto is_in = [&](std::size_t at) { return at >= from && at < from + size; };
  const auto place = [&](std::size_t at) { return at - from + header_bytes; };
  for (const std::size_t at : edits.strip) {
    if (is_in(at)) put(message_, place(at), std::array<std::uint8_t, 2>{});
  }
  if (!what.lease_at) return;
  lease_at_ = place(what.lease_at->at);
  lease_is_little_ = what.lease_at->little;
}

Octets AnnouncementCopy::with(Duration lease, std::int64_t number) const {
  Octets message = message_;
  const bool number_is_little = (message[header_bytes + 1] & little) != 0;
  put(message, header_bytes + submessage_header + before_number,
      number_bytes(number, number_is_little));
  if (has_lease()) put(message, lease_at_, lease_bytes(lease, lease_is_little_));
  return message;
}

Octets departure_of(const Prefix& prefix, std::int64_t number) {
  constexpr std::uint8_t with_inline_qos = 2;
  constexpr std::uint8_t octets_to_inline_qos = 16;
  Octets message{'R', 'T', 'P', 'S', 2, 2, vendor_eprosima >> 8U, vendor_eprosima & 0xffU};
  const auto add = [&](const auto& bytes) {
    message.insert(message.end(), bytes.begin(), bytes.end());
  };
  add(prefix);
  add(std::array<std::uint8_t, 8>{kind::data, little | with_inline_qos, 0, 0, 0, 0,
                                  octets_to_inline_qos, 0});
  add(std::array<std::uint8_t, 8>{0, 1, 0, 0xc7, 0, 1, 0, 0xc2});  // SPDP's reader and writer
  add(number_bytes(number, true));
  constexpr std::uint8_t disposed_and_unregistered = 3;
  add(std::array<std::uint8_t, 8>{pid::status_info, 0, 4, 0, 0, 0, 0, disposed_and_unregistered});
  add(std::array<std::uint8_t, 4>{pid::key_hash, 0, guid_bytes, 0});
  add(prefix);
  add(std::array<std::uint8_t, 4>{0, 0, 1, 0xc1});  // the participant itself
  add(std::array<std::uint8_t, 4>{pid::sentinel, 0, 0, 0});
  return message;
}

}  // namespace tocsin::rtps_filter
