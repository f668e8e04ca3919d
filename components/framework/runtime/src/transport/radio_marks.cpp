// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_marks.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

constexpr std::size_t ip_and_udp_bytes = 28;

}  // namespace

void RadioMarks::set(const Endpoint& endpoint, int dscp, TrafficClass traffic_class) {
  const std::lock_guard<std::mutex> lock(mutex_);
  marks_[endpoint] = {dscp, traffic_class};
}

void RadioMarks::forget(const Endpoint& endpoint) {
  const std::lock_guard<std::mutex> lock(mutex_);
  marks_.erase(endpoint);
}

int RadioMarks::mark(const std::uint8_t* message, std::size_t size, std::size_t sent) {
  const auto endpoint = sender_in(message, size);
  const bool discovery = !endpoint || is_builtin(*endpoint);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++packets_.packets;
  packets_.bytes += sent + ip_and_udp_bytes;
  if (discovery) {
    ++packets_.discovery_packets;
    packets_.discovery_bytes += sent + ip_and_udp_bytes;
    return network_control;
  }
  const auto found = marks_.find(*endpoint);
  if (found == marks_.end()) return network_control;
  packets_.class_bytes[static_cast<std::size_t>(found->second.traffic_class)] +=
      sent + ip_and_udp_bytes;
  return found->second.dscp;
}

int RadioMarks::mark_stop(std::size_t sent) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++packets_.packets;
  packets_.bytes += sent + ip_and_udp_bytes;
  packets_.class_bytes[static_cast<std::size_t>(TrafficClass::critical)] += sent + ip_and_udp_bytes;
  return network_control;
}

LinkPackets RadioMarks::packets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return packets_;
}

}  // namespace tocsin
