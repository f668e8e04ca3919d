// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/frame.hpp"

#include <cassert>

namespace tocsin::kobuki {

Frame::Frame() {
  bytes_[0] = header_0;
  bytes_[1] = header_1;
}

std::uint8_t* Frame::add(std::uint8_t id, std::size_t size) {
  assert(!closed_);
  if (payload_size() + 2 + size > max_payload) return nullptr;
  bytes_[size_] = id;
  bytes_[size_ + 1] = static_cast<std::uint8_t>(size);
  std::uint8_t* const data = bytes_.data() + size_ + 2;
  size_ += 2 + size;
  return data;
}

void Frame::close() {
  assert(!closed_);
  bytes_[2] = static_cast<std::uint8_t>(payload_size());
  const std::uint8_t checksum = xor_of(ByteView{bytes_.data(), size_}.part(2, size_ - 2));
  bytes_[size_++] = checksum;
  closed_ = true;
}

std::uint8_t xor_of(ByteView bytes) {
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i < bytes.size; ++i) sum ^= bytes[i];
  return sum;
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
