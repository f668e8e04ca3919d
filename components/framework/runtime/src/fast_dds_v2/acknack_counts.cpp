// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/acknack_counts.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

// RTPS 2.2 sections 9.4.4, 9.4.5.1 and 9.4.5.3.
constexpr std::size_t prefix_at = 8;
constexpr std::uint8_t acknack_kind = 0x06;
constexpr std::uint8_t little_endian_flag = 0x01;
constexpr std::uint8_t final_flag = 0x02;
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

/// Adds a pre-emptive one of the same reader for the same writer, as Fast DDS knows it.
void add_preemptive(const std::uint8_t* message, const AckNack& like, std::uint32_t count,
                    std::vector<std::uint8_t>& to) {
  constexpr std::uint8_t bytes = bitmap_at + sizeof count;
  const auto flags = like.little_endian ? little_endian_flag : std::uint8_t{0};
  to.insert(to.end(), {acknack_kind, flags, like.little_endian ? bytes : std::uint8_t{0},
                       like.little_endian ? std::uint8_t{0} : bytes});
  to.insert(to.end(), message + like.content, message + like.content + base_at);
  to.resize(to.size() + bytes - base_at);  // base and number of bits are 0
  put_number(to.data() + to.size() - sizeof count, count, like.little_endian);
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
  Told told{std::nullopt, 0};
  const bool takes_back = !heard.preemptive && heard.base < count.base;
  const bool anew = heard.preemptive || takes_back;
  const std::uint32_t ahead = heard.count - count.heard;
  const bool newer = ahead != 0 && ahead < 1U << 31U;  // serial number arithmetic
  if (takes_back) told.before = ++count.told;
  if (anew) {
    ++count.told;
  } else if (newer) {
    count.told += ahead;
  }
  if (anew || newer) {
    count.heard = heard.count;
    count.base = heard.base;
  }
  told.count = count.told;
  if (counts_.size() >= pairs) {
    older_ = std::move(counts_);
    counts_.clear();
  }
  return told;
}

std::pair<const std::uint8_t*, std::size_t> AckNackCounts::translate(
    const std::uint8_t* message, std::size_t size, std::vector<std::uint8_t>& changed) {
  changed.clear();
  std::size_t copied = 0;
  const auto copy_up_to = [&](std::size_t end) {
    changed.insert(changed.end(), message + copied, message + end);
    copied = end;
  };
  each_acknack(message, size, [&](const AckNack& one) {
    using eprosima::fastdds::rtps::GuidPrefix_t;
    const GuidPrefix_t prefix = id_at<GuidPrefix_t>(message + prefix_at);
    const Pair pair{{prefix, id_at<Entity>(message + one.content)},
                    id_at<Entity>(message + one.content + writer_at)};
    const std::uint32_t count = number_at<std::uint32_t>(message + one.count, one.little_endian);
    const Told told = next(pair, {count, one.base, one.preemptive});
    if (told.count == count && !told.before && !one.preemptive) return;
    copy_up_to(one.content - submessage_header_bytes);
    if (told.before) add_preemptive(message, one, *told.before, changed);
    const std::size_t content = changed.size() + submessage_header_bytes;
    copy_up_to(one.count + sizeof count);
    put_number(changed.data() + changed.size() - sizeof count, told.count, one.little_endian);
    constexpr std::size_t base_low = base_at + sizeof(std::uint32_t);
    if (one.preemptive)
      put_number<std::uint32_t>(changed.data() + content + base_low, 0, one.little_endian);
  });
  if (copied == 0) return {message, size};
  copy_up_to(size);
  return {changed.data(), changed.size()};
}

}  // namespace tocsin
