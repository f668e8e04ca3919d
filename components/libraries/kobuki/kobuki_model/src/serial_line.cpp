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

Time SerialLine::Run::arrival(std::size_t of_left) const {
  return begin + static_cast<std::int64_t>(of_left + 1) * byte_time;
}

void SerialLine::put(ByteView bytes) {
  const std::size_t fit = std::min(bytes.size, max_on_wire - on_wire());
  if (fit > 0) {
    if (wire_.empty() || wire_.back().arrival(wire_.back().left) != line_free_ + byte_time) {
      wire_.push_back({line_free_, 0});
    }
    wire_.back().left += fit;
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + fit);
  }
  line_free_ += static_cast<std::int64_t>(bytes.size) * byte_time;
}

void SerialLine::send(ByteView bytes, Time now) {
  line_free_ = std::max(line_free_, now);
  const double faults =
      params_.noise_probability + params_.loss_probability + params_.flip_probability;
  if (faults <= 0) return put(bytes);
  for (std::uint8_t byte : bytes) {
    if (chance(params_.noise_probability)) {
      const auto invented = static_cast<std::uint8_t>(random_() & 0xFFU);
      put({&invented, 1});
    }
    if (chance(params_.loss_probability)) continue;
    if (chance(params_.flip_probability)) {
      byte = static_cast<std::uint8_t>(byte ^ (1U << (random_() % 8U)));
    }
    put({&byte, 1});
  }
}

Time SerialLine::timer_at_or_after(Time at) const {
  if (timer_ >= at) return timer_;
  const auto periods = (at - timer_ + latency() - Duration{1}) / latency();
  return timer_ + periods * latency();
}

void SerialLine::flush(const Sink& sink) {
  if (packet_ == 0) return;
  sink({bytes_.data(), packet_});
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(packet_));
  packet_ = 0;
}

void SerialLine::receive(Time now, const Sink& sink) {
  Run& run = wire_.front();
  const Time first = run.arrival(0);
  if (timer_ < first) {
    flush(sink);
    timer_ = timer_at_or_after(first);
  }
  const std::size_t room = packet_ < packet_size() ? packet_size() - packet_ : 1;
  const auto come = static_cast<std::size_t>((std::min(now, timer_) - first) / byte_time) + 1;
  const std::size_t count = std::min({room, come, run.left});
  const Time last = run.arrival(count - 1);
  packet_ += count;
  run.left -= count;
  run.begin = last;
  if (run.left == 0) wire_.pop_front();
  if (packet_ < packet_size()) return;
  flush(sink);
  timer_ = last + latency();
}

void SerialLine::deliver(Time now, const Sink& sink) {
  while (!wire_.empty() && wire_.front().arrival(0) <= now) receive(now, sink);
  if (timer_ > now) return;
  flush(sink);
  timer_ = timer_at_or_after(now + Duration{1});
}

void SerialLine::deliver_all(Time now, const Sink& sink) {
  if (may_fill()) return deliver(now, sink);
  packet_ = bytes_.size();
  wire_.clear();
  flush(sink);
  timer_ = timer_at_or_after(now + Duration{1});
}

Time SerialLine::next_delivery() const {
  if (bytes_.empty()) return never;
  const Time by_timer = packet_ == 0 ? timer_at_or_after(wire_.front().arrival(0)) : timer_;
  if (packet_ >= packet_size()) return timer_;  // it was made smaller meanwhile
  std::size_t missing = packet_size() - packet_;
  if (missing > on_wire()) return by_timer;
  auto run = wire_.begin();
  for (; missing > run->left; ++run) missing -= run->left;
  return std::min(by_timer, run->arrival(missing - 1));
}

/// Whether a packet can be full before the timer runs out, which moves the timer.
bool SerialLine::may_fill() const { return latency() / byte_time >= params_.usb_packet_bytes; }

Time SerialLine::last_delivery() const {
  if (wire_.empty() || may_fill()) return next_delivery();
  return timer_at_or_after(wire_.back().arrival(wire_.back().left - 1));
}

void SerialLine::clear() {
  wire_.clear();
  bytes_.clear();
  packet_ = 0;
}

}  // namespace tocsin::kobuki
