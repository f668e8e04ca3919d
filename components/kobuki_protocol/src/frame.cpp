// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/frame.hpp"

#include <cassert>

namespace tocsin::kobuki {

Frame::Frame() {
  bytes_[0] = header_0;
  bytes_[1] = header_1;
}

bool Frame::begin(std::uint8_t id, std::size_t size) {
  if (payload_size() + 2 + size > max_payload) return false;
  u8(id);
  u8(static_cast<std::uint8_t>(size));
  return true;
}

// These two are not inline: a frame is 80 of them in a row, and the checks would fill the
// instruction cache.
void Frame::u8(std::uint8_t value) {
  assert(!closed_ && payload_size() < max_payload);
  bytes_[size_++] = value;
}

void Frame::u16(std::uint16_t value) {
  assert(!closed_ && payload_size() + 1 < max_payload);
  bytes_[size_++] = static_cast<std::uint8_t>(value & 0xFFU);
  bytes_[size_++] = static_cast<std::uint8_t>(value >> 8U);
}

void Frame::close() {
  assert(!closed_);
  bytes_[2] = static_cast<std::uint8_t>(payload_size());
  const std::uint8_t checksum = xor_of(ByteView{bytes_.data(), size_}.part(2, size_ - 2));
  bytes_[size_++] = checksum;
  closed_ = true;
}

std::uint8_t xor_of(ByteView bytes) {
  unsigned sum = 0;
  for (const std::uint8_t byte : bytes) sum ^= byte;
  return static_cast<std::uint8_t>(sum);
}

std::optional<SubPayload> SubPayloadReader::next() {
  if (truncated_ || at_ == payload_.size) return std::nullopt;
  const std::size_t left = payload_.size - at_;
  if (left < 2 || payload_[at_ + 1] > left - 2) {
    truncated_ = true;
    return std::nullopt;
  }
  const std::size_t size = payload_[at_ + 1];
  const SubPayload found{payload_[at_], payload_.part(at_ + 2, size)};
  at_ += 2 + size;
  return found;
}

}  // namespace tocsin::kobuki
