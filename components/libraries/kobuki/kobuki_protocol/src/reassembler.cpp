// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/reassembler.hpp"

#include <algorithm>

namespace tocsin::kobuki {

std::size_t Reassembler::missing() const {
  if (size_ < 3) return min_payload + 4 - size_;  // no frame is shorter
  const std::size_t whole = std::size_t{buffer_[2]} + 4;
  assert(size_ < whole);  // find_frame() accepts or rejects every whole frame
  return whole - size_;
}

void Reassembler::append(ByteView bytes) {
  assert(bytes.size <= buffer_.size() - size_);
  std::copy(bytes.begin(), bytes.end(), buffer_.data() + size_);
  size_ += bytes.size;
}

bool Reassembler::starts_frame_at(std::size_t i) const {
  if (buffer_[i] != header_0) return false;
  return i + 1 == size_ || buffer_[i + 1] == header_1;
}

void Reassembler::skip_to_header(std::size_t from) {
  std::size_t i = from;
  while (i < size_ && !starts_frame_at(i)) ++i;
  counts_.discarded += i;
  drop(i);
}

void Reassembler::drop(std::size_t count) {
  if (count == 0) return;
  const auto* first = buffer_.data() + count;
  std::copy(first, first + (size_ - count), buffer_.data());
  size_ -= count;
}

std::optional<ByteView> Reassembler::find_frame() {
  if (size_ > 0 && !starts_frame_at(0)) skip_to_header(1);
  while (size_ >= 3) {
    const std::size_t length = buffer_[2];
    if (length >= min_payload) {
      if (size_ < length + 4) return std::nullopt;
      const ByteView frame{buffer_.data(), length + 4};
      if (xor_of(frame.part(2, length + 2)) == 0) return frame.part(3, length);
    }
    ++counts_.rejected;
    skip_to_header(1);
  }
  return std::nullopt;
}

void Reassembler::remove_frame() {
  ++counts_.frames;
  drop(std::size_t{buffer_[2]} + 4);
}

void Reassembler::clear() {
  counts_.discarded += size_;
  size_ = 0;
}

}  // namespace tocsin::kobuki
