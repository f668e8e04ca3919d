// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/decoder.hpp"

#include <algorithm>
#include <array>

namespace tocsin::rplidar {
namespace {

constexpr std::size_t readings_to_trust = 4;

bool rises(double from_rad, double to_rad) {
  return whole_turn(to_rad - from_rad) < Decoder::most_step_rad;
}

}  // namespace

void Decoder::clear() {
  counts_.discarded += buffer_.size();
  buffer_.clear();
  expected_.reset();
  trusted_ = false;
  capsule_.reset();
}

void Decoder::feed(ByteView bytes, const Sink& sink) {
  for (const std::uint8_t byte : bytes) {
    buffer_.push_back(byte);
    while (take(sink)) {
    }
  }
}

/// Whether something was taken from the buffer, so that there may be more.
bool Decoder::take(const Sink& sink) {
  if (buffer_.empty()) return false;
  if (!expected_) return take_descriptor(sink);
  if (expected_ == AnswerType::scan) return take_reading(sink);
  if (expected_ == AnswerType::express) return take_capsule(sink);
  return take_single(sink);
}

/// Empty as long as the first bytes are, or may become, no descriptor that is known.
std::optional<AnswerType> Decoder::descriptor_at_front() const {
  if (buffer_.size() < descriptor_size) return std::nullopt;
  for (const AnswerType type :
       {AnswerType::info, AnswerType::health, AnswerType::scan, AnswerType::express}) {
    const Bytes wanted = descriptor(type);
    if (std::equal(wanted.begin(), wanted.end(), buffer_.begin())) return type;
  }
  return std::nullopt;
}

bool Decoder::take_descriptor(const Sink& sink) {
  if (const auto type = descriptor_at_front()) {
    drop(descriptor_size);
    expected_ = type;
    trusted_ = false;
    capsule_.reset();
    if (*type == AnswerType::scan || *type == AnswerType::express) sink(ScanBegins{*type});
    return true;
  }
  const bool may_be_one = buffer_.size() < descriptor_size && buffer_[0] == 0xA5;
  if (may_be_one) return false;
  drop(1);
  ++counts_.discarded;
  return true;
}

bool Decoder::take_single(const Sink& sink) {
  const std::size_t size = size_of(*expected_);
  if (buffer_.size() < size) return false;
  const ByteView bytes = view(0, size);
  const Answer answer =
      *expected_ == AnswerType::info ? Answer(decode_info(bytes)) : Answer(decode_health(bytes));
  drop(size);
  expected_.reset();
  sink(answer);
  return true;
}

bool Decoder::has_good_readings(std::size_t count) const {
  double before_rad = last_angle_rad_;
  for (std::size_t i = 0; i < count; ++i) {
    const ByteView bytes = view(i * reading_size, reading_size);
    if (!is_reading(bytes)) return false;
    const double angle_rad = decode_reading(bytes).angle_rad;
    if ((trusted_ || i > 0) && !rises(before_rad, angle_rad)) return false;
    before_rad = angle_rad;
  }
  return true;
}

bool Decoder::take_reading(const Sink& sink) {
  const std::size_t needed = trusted_ ? 1 : readings_to_trust;
  if (buffer_.size() < needed * reading_size) return false;
  if (has_good_readings(needed)) {
    for (std::size_t i = 0; i < needed; ++i) emit_reading(sink);
    trusted_ = true;
    return true;
  }
  // A reading never begins with A5 5A: the check bit of its angle would be wrong.
  if (buffer_[0] == 0xA5 && buffer_[1] == 0x5A) {
    if (buffer_.size() < descriptor_size) return false;
    if (descriptor_at_front()) return take_descriptor(sink);
  }
  if (trusted_) ++counts_.rejected;
  trusted_ = false;
  drop(1);
  ++counts_.discarded;
  return true;
}

void Decoder::emit_reading(const Sink& sink) {
  const Reading reading = decode_reading(view(0, reading_size));
  drop(reading_size);
  last_angle_rad_ = reading.angle_rad;
  ++counts_.readings;
  sink(reading);
}

bool Decoder::take_capsule(const Sink& sink) {
  if (descriptor_at_front()) return take_descriptor(sink);
  const bool may_be_one =
      buffer_[0] >> 4U == 0xA && (buffer_.size() == 1 || buffer_[1] >> 4U == 0x5);
  if (!may_be_one) {
    capsule_.reset();
    drop(1);
    ++counts_.discarded;
    return true;
  }
  if (buffer_.size() < capsule_size) return false;
  if (!is_capsule(view(0, capsule_size))) {
    ++counts_.rejected;
    ++counts_.discarded;
    capsule_.reset();
    drop(1);
    return true;
  }
  const Capsule next = decode_capsule(view(0, capsule_size));
  drop(capsule_size);
  if (capsule_ && !next.begins) {
    for (const Reading& reading : readings_of(*capsule_, next.start_rad)) {
      ++counts_.readings;
      sink(reading);
    }
  }
  capsule_ = next;
  return true;
}

void Decoder::drop(std::size_t count) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace tocsin::rplidar
