// SPDX-License-Identifier: Apache-2.0
#include "submessages.hpp"

#include <algorithm>
#include <cstring>

#include "parameters.hpp"

namespace tocsin::rtps_filter {
namespace {

constexpr std::uint8_t flag_little = 1U << 0U;
constexpr std::uint8_t flag_inline_qos = 1U << 1U;
constexpr std::uint8_t flag_data = 1U << 2U;
constexpr std::uint8_t flag_key = 1U << 3U;
constexpr std::uint8_t flag_key_of_fragment = 1U << 2U;

/// Numbers end far below what the signed 64 bits hold: nobody gets there, and sums stay exact.
constexpr std::int64_t last_number = std::int64_t{1} << 53U;
bool is_number(std::int64_t number) { return number >= 1 && number <= last_number; }

/// The bits of a set of numbers, after its base (RTPS 2.5, 9.4.2.6): how many are in its range.
/// Nothing when there are more than 256, or they are not there.
std::optional<std::uint32_t> read_bitmap(Cursor& at) {
  const std::uint32_t bits = at.u32();
  if (!at.ok() || bits > 256) return std::nullopt;
  at.skip(std::size_t{(bits + 31) / 32} * 4);
  if (!at.ok()) return std::nullopt;
  return bits;
}

/// What DATA and DATA_FRAG have in common. `fixed`: bytes from octetsToInlineQos to the inline QoS
/// in this version of the protocol; later versions may put more between.
Checked<Data> read_sample(const Submessage& submessage, std::uint16_t fixed) {
  Cursor at = submessage.content;
  Data data;
  at.skip(2);  // extra flags
  const std::uint16_t octets_to_inline_qos = at.u16();
  Cursor behind = at;
  data.reader = at.entity();
  data.writer = at.entity();
  data.number = at.number();
  if (!at.ok()) return DropReason::submessage_length;
  if (!is_number(data.number)) return DropReason::sequence_number;
  // Fast DDS reads it with a sign.
  constexpr std::uint16_t largest = 0x7fff;
  if (octets_to_inline_qos < fixed || octets_to_inline_qos > largest ||
      octets_to_inline_qos > behind.left()) {
    return DropReason::inline_qos_offset;
  }
  behind.skip(octets_to_inline_qos);
  if ((submessage.flags & flag_inline_qos) != 0) {
    const auto bytes = bytes_of_list(behind);
    if (!bytes) return DropReason::parameter_length;
    data.inline_qos = behind.part(*bytes);
    if (const Wrong wrong = check_inline_qos(data.inline_qos)) return *wrong;
  }
  data.payload = behind;
  return data;
}

/// Fragments that lie within their sample and are all there.
Wrong check_fragments(const Data::Fragments& fragments, std::size_t payload_bytes,
                      std::uint32_t sample_bytes) {
  const std::uint64_t first = fragments.first;
  const std::uint64_t count = fragments.count;
  const std::uint64_t size = fragments.size;
  const std::uint64_t sample = fragments.sample;
  if (first == 0 || count == 0 || size == 0 || sample == 0) return DropReason::fragment;
  if (sample > sample_bytes) return DropReason::sample_size;
  if (first - 1 + count > (sample + size - 1) / size) return DropReason::fragment;
  const std::uint64_t before = (first - 1) * size;
  if (payload_bytes < std::min(count * size, sample - before)) return DropReason::fragment;
  return std::nullopt;
}

}  // namespace

std::optional<Header> read_header(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::uint8_t version = 2;
  if (size < header_bytes || std::memcmp(bytes, "RTPS", 4) != 0 || bytes[4] != version) {
    return std::nullopt;
  }
  Header header{{}, static_cast<std::uint16_t>(bytes[6] << 8U | bytes[7])};
  std::copy_n(bytes + 8, header.prefix.size(), header.prefix.begin());
  return header;
}

std::optional<Submessage> Submessages::next() {
  if (at_.left() == 0) return std::nullopt;
  Submessage submessage;
  submessage.kind = at_.u8();
  submessage.flags = at_.u8();
  at_.set_little((submessage.flags & flag_little) != 0);
  std::size_t length = at_.u16();
  const bool may_be_empty = submessage.kind == kind::info_ts || submessage.kind == kind::pad;
  if (length == 0 && !may_be_empty) length = at_.left();  // until the end of the message
  submessage.content = at_.part(length);
  submessage.last = at_.left() == 0;
  wrong_ = !at_.ok() || (!submessage.last && length % 4 != 0);
  if (wrong_) return std::nullopt;
  return submessage;
}

Checked<Data> read_data(const Submessage& submessage) {
  constexpr std::uint16_t fixed = 16;
  auto read = read_sample(submessage, fixed);
  auto* data = std::get_if<Data>(&read);
  if (data == nullptr) return read;
  data->has_payload = (submessage.flags & flag_data) != 0;
  data->has_key = (submessage.flags & flag_key) != 0;
  if (data->has_payload && data->has_key) return DropReason::payload;
  return read;
}

Checked<Data> read_data_frag(const Submessage& submessage, std::uint32_t sample_bytes) {
  constexpr std::uint16_t fixed = 28;
  auto read = read_sample(submessage, fixed);
  auto* data = std::get_if<Data>(&read);
  if (data == nullptr) return read;
  Cursor at = submessage.content;
  at.skip(2 + 2 + 4 + 4 + 8);  // until behind the number
  data->fragments.first = at.u32();
  data->fragments.count = at.u16();
  data->fragments.size = at.u16();
  data->fragments.sample = at.u32();
  if (!at.ok()) return DropReason::submessage_length;
  if (const Wrong wrong = check_fragments(data->fragments, data->payload.left(), sample_bytes)) {
    return *wrong;
  }
  data->has_key = (submessage.flags & flag_key_of_fragment) != 0;
  data->has_payload = !data->has_key;
  return read;
}

Checked<Heartbeat> read_heartbeat(const Submessage& submessage) {
  Cursor at = submessage.content;
  Heartbeat heartbeat;
  heartbeat.reader = at.entity();
  heartbeat.writer = at.entity();
  heartbeat.first = at.number();
  const std::int64_t last = at.number();
  heartbeat.count = at.u32();
  if (!at.ok()) return DropReason::submessage_length;
  if (!is_number(heartbeat.first) || last < heartbeat.first - 1 || last > last_number) {
    return DropReason::sequence_number;
  }
  return heartbeat;
}

std::array<std::uint8_t, 8> number_bytes(std::int64_t number, bool little) {
  std::array<std::uint8_t, 8> bytes{};
  std::size_t at = 0;
  for (const unsigned word : {32U, 0U}) {
    for (unsigned octet = 0; octet < 4; ++octet) {
      const unsigned shift = word + 8 * (little ? octet : 3 - octet);
      bytes[at++] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> shift);
    }
  }
  return bytes;
}

std::array<std::uint8_t, 16> numbers_of(std::int64_t first, std::int64_t last, bool little) {
  std::array<std::uint8_t, 16> bytes{};
  const auto head = number_bytes(first, little);
  const auto tail = number_bytes(last, little);
  std::copy(head.begin(), head.end(), bytes.begin());
  std::copy(tail.begin(), tail.end(), bytes.begin() + head.size());
  return bytes;
}

Checked<Gap> read_gap(const Submessage& submessage) {
  Cursor at = submessage.content;
  Gap gap;
  gap.reader = at.entity();
  gap.writer = at.entity();
  const std::int64_t start = gap.start = at.number();
  const std::int64_t base = at.number();
  const auto bits = read_bitmap(at);
  if (!bits) return at.ok() ? DropReason::sequence_number : DropReason::submessage_length;
  if (!is_number(start) || !is_number(base)) return DropReason::sequence_number;
  gap.numbers = static_cast<std::uint64_t>(std::max<std::int64_t>(base - start, 0)) + *bits;
  gap.bits = *bits;
  return gap;
}

Wrong check_acknack(const Submessage& submessage) {
  Cursor at = submessage.content;
  at.skip(4 + 4);
  const std::int64_t base = at.number();  // zero: a reader that has heard nothing yet
  const auto bits = read_bitmap(at);
  at.skip(4);  // count
  if (!at.ok()) return DropReason::submessage_length;
  if (!bits || base < 0 || base > last_number) return DropReason::sequence_number;
  return std::nullopt;
}

Wrong check_nack_frag(const Submessage& submessage) {
  Cursor at = submessage.content;
  at.skip(4 + 4);
  const std::int64_t number = at.number();
  const std::uint32_t base = at.u32();
  const auto bits = read_bitmap(at);
  at.skip(4);  // count
  if (!at.ok()) return DropReason::submessage_length;
  if (!bits || !is_number(number) || base == 0) return DropReason::sequence_number;
  return std::nullopt;
}

}  // namespace tocsin::rtps_filter
