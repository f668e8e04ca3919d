// SPDX-License-Identifier: Apache-2.0
#include "kobuki_model/serial_line.hpp"

#include <algorithm>

namespace tocsin::kobuki {
namespace {

constexpr Duration byte_time{86806};  // 10 bits at 115200 baud
constexpr std::size_t max_on_wire = 4096;

}  // namespace

SerialLine::SerialLine(const LineParams& params, std::uint64_t seed, Time now)
    : params_(params), random_(seed), line_free_(now), timer_(now + latency()) {}

bool SerialLine::chance(double probability) {
  if (probability <= 0) return false;
  return std::uniform_real_distribution<double>(0, 1)(random_) < probability;
}

std::size_t SerialLine::packet_size() const {
  return static_cast<std::size_t>(params_.usb_packet_bytes);
}

void SerialLine::put(std::uint8_t byte) {
  line_free_ += byte_time;
  if (wire_.size() < max_on_wire) wire_.push_back({line_free_, byte});
}

void SerialLine::send(ByteView bytes, Time now) {
  line_free_ = std::max(line_free_, now);
  const double faults =
      params_.noise_probability + params_.loss_probability + params_.flip_probability;
  if (faults <= 0) {
    std::for_each(bytes.begin(), bytes.end(), [this](std::uint8_t byte) { put(byte); });
    return;
  }
  for (std::uint8_t byte : bytes) {
    if (chance(params_.noise_probability)) put(static_cast<std::uint8_t>(random_() & 0xFFU));
    if (chance(params_.loss_probability)) continue;
    if (chance(params_.flip_probability)) {
      byte = static_cast<std::uint8_t>(byte ^ (1U << (random_() % 8U)));
    }
    put(byte);
  }
}

Time SerialLine::timer_at_or_after(Time at) const {
  if (timer_ >= at) return timer_;
  const auto periods = (at - timer_ + latency() - Duration{1}) / latency();
  return timer_ + periods * latency();
}

void SerialLine::flush(const Sink& sink) {
  if (packet_.empty()) return;
  sink({packet_.data(), packet_.size()});
  packet_.clear();
}

void SerialLine::deliver(Time now, const Sink& sink) {
  while (!wire_.empty() && wire_.front().at <= now) {
    const Arriving next = wire_.front();
    wire_.pop_front();
    if (timer_ < next.at) {
      flush(sink);
      timer_ = timer_at_or_after(next.at);
    }
    packet_.push_back(next.byte);
    if (packet_.size() < packet_size()) continue;
    flush(sink);
    timer_ = next.at + latency();
  }
  if (timer_ > now) return;
  flush(sink);
  timer_ = timer_at_or_after(now + Duration{1});
}

Time SerialLine::next_delivery() const {
  if (packet_.empty() && wire_.empty()) return never;
  const Time by_timer = packet_.empty() ? timer_at_or_after(wire_.front().at) : timer_;
  if (packet_.size() >= packet_size()) return timer_;  // it was made smaller meanwhile
  const std::size_t missing = packet_size() - packet_.size();
  if (missing > wire_.size()) return by_timer;
  return std::min(by_timer, wire_[missing - 1].at);
}

Time SerialLine::last_delivery() const {
  const bool may_fill = latency() / byte_time >= params_.usb_packet_bytes;  // that moves the timer
  if (wire_.empty() || may_fill) return next_delivery();
  return timer_at_or_after(wire_.back().at);
}

void SerialLine::clear() {
  wire_.clear();
  packet_.clear();
}

}  // namespace tocsin::kobuki
