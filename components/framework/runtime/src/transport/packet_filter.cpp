// SPDX-License-Identifier: Apache-2.0
#include "transport/packet_filter.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "foundation/time.hpp"
#include "runtime/middleware/link_limits.hpp"
#include "watch/dropped_packets.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using rtps_filter::ipv4;
using rtps_filter::Limits;

/// Nothing when the text is no IPv4 address.
std::optional<std::uint32_t> address_of(const std::string& text) {
  in_addr parsed{};
  if (inet_pton(AF_INET, text.c_str(), &parsed) != 1) return std::nullopt;
  return ntohl(parsed.s_addr);
}

Limits limits_on_radio(const std::set<std::uint32_t>& configured) {
  constexpr double wifi_bytes_per_s = 64e6;
  Limits limits;
  limits.sample_bytes = 16U << 20U;
  // A picture crosses 2 s after a forger ends that has begun the largest sample.
  limits.unfinished_bytes.per_s = 8U << 20U;
  limits.bytes = {wifi_bytes_per_s, wifi_bytes_per_s};
  limits.participants = 32;  // each is sent announcements over the radio
  limits.source_has_port = false;
  limits.participant_has_address = true;
  limits.hears = [configured](std::uint32_t address) { return configured.count(address) > 0; };
  limits.answers = limits.hears;
  limits.yields_after = limits.departure_wait = std::chrono::seconds(1);
  limits.longest_lease = seconds(link_lease_s);
  return limits;
}

rtps_filter::Source source_in(const rtps::Locator_t& from) {
  const rtps::octet* const a = rtps::IPLocator::getIPv4(from);
  return {ipv4(a[0], a[1], a[2], a[3]), rtps::IPLocator::getPhysicalPort(from)};
}

bool is_stepped(const rtps_filter::Inspection& inspection) {
  return std::any_of(inspection.step.begin(), inspection.step.end(), [](const auto& step) {
    return step.size == rtps_filter::Inspection::Step::of_heartbeat;
  });
}

std::array<std::uint8_t, 12> octets_of(const rtps::GuidPrefix_t& participant) {
  std::array<std::uint8_t, 12> octets{};
  std::copy_n(participant.value, octets.size(), octets.begin());
  return octets;
}

}  // namespace

Limits limits_in(const Surroundings& surroundings) {
  if (!surroundings.radio) return {};
  std::set<std::uint32_t> configured;
  const auto add = [&](const std::string& text) {
    if (const auto address = address_of(text)) configured.insert(*address);
  };
  add(surroundings.address);
  std::for_each(surroundings.peers.begin(), surroundings.peers.end(), add);
  return limits_on_radio(configured);
}

std::function<bool(std::uint32_t)> local_in(const Surroundings& surroundings) {
  if (!surroundings.radio) return [](std::uint32_t) { return true; };
  return [own = address_of(surroundings.address)](std::uint32_t address) { return address == own; };
}

rtps_filter::Sender PacketFilter::sender(const rtps_filter::Source& source) {
  const bool has_user = is_local_ && is_local_(source.address);
  return has_user ? users_.sender(source) : rtps_filter::Sender::trusted;
}

rtps_filter::Inspection PacketFilter::inspect(const std::uint8_t* bytes, std::size_t size,
                                              const rtps::Locator_t& from, Port at) {
  const rtps_filter::Source source = source_in(from);
  const rtps_filter::Sender whose = sender(source);
  const Time now = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  rtps_filter::Inspection inspection = filter_.inspect(bytes, size, source, now, whose);
  if (at == Port::discovery && !inspection.drop) {
    auto due = filter_.take_due();
    due.insert(due.end(), std::move_iterator(inspection.before.begin()),
               std::move_iterator(inspection.before.end()));
    inspection.before = std::move(due);
  }
  lock.unlock();
  if (inspection.drop) {
    count_dropped_packet(*inspection.drop, source.address);
    return inspection;
  }
  if (is_stepped(inspection)) {
    count_dropped_packet(rtps_filter::DropReason::sequence_jump, source.address);
  }
  if (others_) others_->hear(bytes, size, source.address);
  if (numbers_) numbers_->see(bytes, size, now);
  return inspection;
}

void PacketFilter::took(Duration cpu) {
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_.took(cpu, std::chrono::steady_clock::now());
}

PieceAssembly::Result PacketFilter::assemble(const std::uint8_t* bytes, std::size_t size,
                                             const rtps::Locator_t& from) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const rtps_filter::Source source = source_in(from);
  return pieces_.add(bytes, size, std::uint64_t{source.address} << 16U | source.port,
                     std::chrono::steady_clock::now());
}

void PacketFilter::authenticate(const rtps::GuidPrefix_t& participant) {
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_.authenticate(octets_of(participant));
}

void PacketFilter::supersede(const rtps::GuidPrefix_t& participant) {
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_.supersede(octets_of(participant), std::chrono::steady_clock::now());
}

void PacketFilter::forget(const rtps::GuidPrefix_t& participant) {
  const std::lock_guard<std::mutex> lock(mutex_);
  filter_.forget(octets_of(participant));
}

}  // namespace tocsin
