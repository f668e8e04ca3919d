// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/acknack_counts.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "link/rtps_message.hpp"

namespace tocsin {
namespace {

// RTPS 2.2 sections 9.4.4, 9.4.5.1 and 9.4.5.3.
constexpr std::size_t prefix_at = 8;
constexpr std::uint8_t acknack_kind = 0x06;
constexpr std::uint8_t little_endian_flag = 0x01;
constexpr std::uint8_t final_flag = 0x02;
constexpr std::size_t flags_before_content = 3;
constexpr std::size_t writer_at = 4;
constexpr std::size_t base_at = 8;
constexpr std::size_t bits_at = 16;
constexpr std::size_t bitmap_at = 20;
constexpr std::size_t most_bits = 256;
/// Pairs of a reader and a writer that are remembered for sure.
constexpr std::size_t pairs = 4096;

/// Sequence numbers are sent high word first (RTPS 2.2 section 9.4.2.5).
std::uint64_t sequence_at(const std::uint8_t* at, bool little_endian) {
  const std::uint64_t high = number_at<std::uint32_t>(at, little_endian);
  return high << 32U | number_at<std::uint32_t>(at + sizeof(std::uint32_t), little_endian);
}

/// Where the parts of an ACKNACK stand in its message.
struct AckNack {
  std::size_t content;
  std::size_t count;
  bool little_endian;
  std::uint64_t base;  ///< the reader has all before it
  bool preemptive;     ///< asks for a HEARTBEAT and for nothing else
};

/// Makes it a pre-emptive one that Fast DDS knows. What stood behind its count stays behind it.
void make_preemptive(std::uint8_t* message, const AckNack& one, std::uint32_t count) {
  std::uint8_t* const content = message + one.content;
  std::fill(content + base_at, content + bitmap_at, std::uint8_t{0});  // base and number of bits
  put_number(content + bitmap_at, count, one.little_endian);
  *(content - flags_before_content) &= static_cast<std::uint8_t>(~final_flag);
}

/// Nothing when it is no ACKNACK, or one that is cut off.
std::optional<AckNack> acknack_in(const std::uint8_t* message, const Submessage& one) {
  if (one.kind != acknack_kind || one.bytes < bitmap_at) return std::nullopt;
  const auto content = static_cast<std::size_t>(one.content - message);
  AckNack found{content, 0, (one.flags & little_endian_flag) != 0, 0, false};
  const std::uint32_t bits = number_at<std::uint32_t>(one.content + bits_at, found.little_endian);
  if (bits > most_bits) return std::nullopt;
  const std::size_t count = bitmap_at + (bits + 31) / 32 * 4;
  if (count + sizeof(std::uint32_t) > one.bytes) return std::nullopt;
  found.count = content + count;
  found.base = sequence_at(one.content + base_at, found.little_endian);
  found.preemptive = (one.flags & final_flag) == 0 && bits == 0 && found.base <= 1;
  return found;
}

template <class OnAckNack>
void each_acknack(const std::uint8_t* message, std::size_t size, const OnAckNack& on_acknack) {
  Submessages all(message, size);
  while (const auto one = all.next()) {
    if (const auto found = acknack_in(message, *one)) on_acknack(*found);
  }
}

template <class Id>
Id id_at(const std::uint8_t* at) {
  Id id;
  std::copy_n(at, sizeof id.value, id.value);
  return id;
}

}  // namespace

AckNackCounts::Told AckNackCounts::next(const Pair& pair, const Heard& heard) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto place = counts_.try_emplace(pair);
  Count& count = place.first->second;
  if (place.second) {
    if (const auto known = older_.find(pair); known != older_.end()) count = known->second;
  }
  const bool anew = heard.preemptive || heard.base < count.base;
  const std::uint32_t ahead = heard.count - count.heard;
  const bool newer = ahead != 0 && ahead < 1U << 31U;  // serial number arithmetic
  if (anew) {
    ++count.told;
  } else if (newer) {
    count.told += ahead;
  }
  if (anew || newer) {
    count.heard = heard.count;
    count.base = heard.base;
  }
  const Told told{count.told, anew};
  if (counts_.size() >= pairs) {
    older_ = std::move(counts_);
    counts_.clear();
  }
  return told;
}

std::pair<const std::uint8_t*, std::size_t> AckNackCounts::translate(
    const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed) {
  const std::uint8_t* result = message;
  each_acknack(message, size, [&](const AckNack& one) {
    using eprosima::fastrtps::rtps::GuidPrefix_t;
    const GuidPrefix_t prefix = id_at<GuidPrefix_t>(message + prefix_at);
    const Pair pair{{prefix, id_at<Entity>(message + one.content)},
                    id_at<Entity>(message + one.content + writer_at)};
    const std::uint32_t count = number_at<std::uint32_t>(message + one.count, one.little_endian);
    const Told told = next(pair, {count, one.base, one.preemptive});
    if (told.count == count && !told.anew) return;
    if (result == message) {
      changed.assign(message, message + size);
      result = changed.data();
    }
    if (told.anew) return make_preemptive(changed.data(), one, told.count);
    put_number(changed.data() + one.count, told.count, one.little_endian);
  });
  return {result, size};
}

}  // namespace tocsin
