// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_marks.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr std::size_t ip_and_udp_bytes = 28;

}  // namespace

void RadioMarks::set(const Endpoint& endpoint, const Mark& mark) {
  const std::lock_guard<std::mutex> lock(mutex_);
  marks_[endpoint] = mark;
}

void RadioMarks::forget(const Endpoint& endpoint) {
  const std::lock_guard<std::mutex> lock(mutex_);
  marks_.erase(endpoint);
}

int RadioMarks::mark(const std::uint8_t* message, std::size_t size, std::size_t sent) {
  const auto endpoint = sender_in(message, size);
  const bool discovery = !endpoint || is_builtin(*endpoint);
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint64_t bytes = sent + ip_and_udp_bytes;
  const auto found = discovery ? marks_.end() : marks_.find(*endpoint);
  if (found != marks_.end()) {
    packets_.add(found->second.traffic_class, found->second.purpose, bytes);
    return found->second.dscp;
  }
  if (discovery) {
    packets_.add_discovery(bytes);
  } else {
    ++packets_.packets;
    packets_.bytes += bytes;
  }
  return network_control;
}

int RadioMarks::mark_stop(std::size_t sent) {
  const std::lock_guard<std::mutex> lock(mutex_);
  packets_.add_stop(sent + ip_and_udp_bytes, true);
  return network_control;
}

void RadioMarks::note_rider(std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  packets_.add_stop(bytes, false);
}

LinkPackets RadioMarks::packets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return packets_;
}

}  // namespace tocsin
