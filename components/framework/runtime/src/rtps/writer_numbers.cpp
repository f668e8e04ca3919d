// SPDX-License-Identifier: Apache-2.0
#include "rtps/writer_numbers.hpp"

#include <algorithm>
#include <utility>

#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

constexpr std::uint8_t data = 0x15;  // RTPS 2.2 section 9.4.5.1.1
constexpr std::uint8_t data_frag = 0x16;
constexpr std::size_t writer_in_sample = 8;  // behind flags, octets to inline QoS and reader
constexpr std::size_t number_in_sample = 12;
constexpr std::size_t prefix_in_header = 8;

}  // namespace

bool WriterNumbers::is_muted(const Guid& writer, std::uint64_t number, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (writers_.size() >= most_writers && writers_.count(writer) == 0) writers_.clear();
  Numbers& known = writers_[writer];
  if (number > known.highest) {
    known = {number, 0, {}};
    return false;
  }
  if (number == known.highest) return false;
  if (known.lower == 0 || number <= known.lower) {
    known.lower = number;
    known.since = now;
    return false;
  }
  if (now - known.since < contradicts_after) return false;
  known = {number, 0, {}};
  return true;
}

void WriterNumbers::tell(const Guid& writer) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    muted_.insert(writer);
  }
  wake_();
}

std::set<WriterNumbers::Guid> WriterNumbers::take_muted() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(muted_, {});
}

void WriterNumbers::see(const std::uint8_t* packet, std::size_t size, Time now) {
  if (size < header_bytes) return;
  Guid writer;
  std::copy_n(packet + prefix_in_header, rtps::GuidPrefix_t::size, writer.guidPrefix.value);
  Submessages all(packet, size);
  while (const auto one = all.next()) {
    const bool is_sample = one->kind == data || one->kind == data_frag;
    if (!is_sample || one->bytes < number_in_sample + 8) continue;
    std::copy_n(one->content + writer_in_sample, rtps::EntityId_t::size, writer.entityId.value);
    if (is_builtin(writer.entityId)) continue;
    const bool little_endian = (one->flags & 1U) != 0;
    const std::uint8_t* const at = one->content + number_in_sample;
    const std::uint64_t number = std::uint64_t{tocsin::number_at<std::uint32_t>(at, little_endian)}
                                     << 32U |
                                 tocsin::number_at<std::uint32_t>(at + 4, little_endian);
    if (is_muted(writer, number, now)) tell(writer);
  }
}

}  // namespace tocsin
