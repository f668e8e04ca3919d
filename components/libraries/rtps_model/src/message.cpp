// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/message.hpp"

#include <algorithm>

namespace tocsin::rtps {
namespace {

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// Of a list of numbers that begins at `base`.
template <class Number>
std::size_t bitmap_bytes(Number base, const std::vector<Number>& numbers) {
  if (numbers.empty()) return 0;
  const auto bits = static_cast<std::size_t>(numbers.back() - base) + 1;
  return (bits + 31) / 32 * 4;
}

struct Size {
  std::size_t operator()(const Data& data) const {
    const std::size_t header = data.fragment == 0 ? wire::data_header : wire::data_fragment_header;
    return wire::info_timestamp + header + padded(data.sample->bytes_of(data.fragment));
  }
  std::size_t operator()(const Heartbeat&) const { return wire::heartbeat; }
  std::size_t operator()(const Gap& gap) const {
    constexpr std::size_t fixed = 32;
    return fixed + bitmap_bytes(gap.end, gap.others);
  }
  std::size_t operator()(const AckNack& acknack) const {
    constexpr std::size_t fixed = 28;
    return fixed + bitmap_bytes(acknack.base, acknack.missing);
  }
  std::size_t operator()(const NackFrag& nack) const {
    constexpr std::size_t fixed = 32;
    return fixed + (nack.missing.empty() ? 0 : bitmap_bytes(nack.missing.front(), nack.missing));
  }
};

}  // namespace

Fragment Sample::fragments() const {
  if (fragment_bytes == 0) return 0;
  return static_cast<Fragment>((bytes + fragment_bytes - 1) / fragment_bytes);
}

std::size_t Sample::bytes_of(Fragment fragment) const {
  if (fragment == 0) return bytes;
  return std::min(fragment_bytes, bytes - (fragment - 1) * fragment_bytes);
}

Gap gap_of(const std::vector<Sequence>& absent) {
  Gap gap{absent.front(), absent.front(), {}};
  for (const Sequence sequence : absent) {
    if (sequence == gap.end) {
      ++gap.end;
    } else {
      gap.others.push_back(sequence);
    }
  }
  return gap;
}

std::size_t size_of(const Submessage& submessage) { return std::visit(Size{}, submessage); }

std::vector<std::size_t> packets_of(std::size_t bytes, std::size_t receivers,
                                    std::size_t fragment_bytes) {
  const std::size_t around = wire::ip_and_udp + wire::message_header + wire::info_timestamp +
                             wire::statistics + (receivers == 1 ? wire::info_destination : 0);
  if (bytes <= fragment_bytes) return {around + wire::data_header + padded(bytes)};
  std::vector<std::size_t> packets;
  for (std::size_t left = bytes; left > 0; left -= std::min(left, fragment_bytes)) {
    packets.push_back(around + wire::data_fragment_header + padded(std::min(left, fragment_bytes)));
  }
  return packets;
}

}  // namespace tocsin::rtps
