// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_marks.hpp"

#include <utility>

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

void RadioMarks::mute(std::set<std::uint32_t> addresses) {
  const std::lock_guard<std::mutex> lock(mutex_);
  muted_ = std::move(addresses);
}

bool RadioMarks::withholds(const std::uint8_t* message, std::size_t size,
                           std::uint32_t address) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (muted_.count(address) == 0) return false;
  const auto endpoint = sender_in(message, size);
  return endpoint && marks_.count(*endpoint) != 0;
}

RadioMarks::Way RadioMarks::mark(const std::uint8_t* message, std::size_t size, std::size_t sent) {
  const auto endpoint = sender_in(message, size);
  const bool discovery = !endpoint || is_builtin(*endpoint);
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint64_t bytes = sent + ip_and_udp_bytes;
  const auto found = discovery ? marks_.end() : marks_.find(*endpoint);
  if (found != marks_.end()) {
    const Mark& mark = found->second;
    packets_.add(mark.traffic_class, mark.purpose, bytes);
    if (mark.path != 0) packets_.second_bytes += bytes;
    return {mark.dscp, {mark.path == 0, mark.path != 0}};
  }
  const Way way{network_control, {true, has_second_}};
  for (const bool goes : way.paths) {
    if (goes) note_unknown(bytes, discovery);
  }
  if (way.paths[1]) packets_.second_bytes += bytes;
  return way;
}

void RadioMarks::note_unknown(std::uint64_t bytes, bool discovery) {
  if (discovery) return packets_.add_discovery(bytes);
  ++packets_.packets;
  packets_.bytes += bytes;
}

int RadioMarks::mark_stop(std::size_t sent, PathIndex path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  packets_.add_stop(sent + ip_and_udp_bytes, true);
  if (path != 0) packets_.second_bytes += sent + ip_and_udp_bytes;
  return network_control;
}

void RadioMarks::note_rider(std::size_t bytes, PathIndex path) {
  const std::lock_guard<std::mutex> lock(mutex_);
  packets_.add_stop(bytes, false);
  if (path != 0) packets_.second_bytes += bytes;
}

LinkPackets RadioMarks::packets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return packets_;
}

}  // namespace tocsin
