// SPDX-License-Identifier: Apache-2.0
#include "sent_packets.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "rtps_view.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

std::uint8_t kind_of(const RtpsPacket& packet) {
  Submessages all(packet.message, packet.bytes);
  while (const auto one = all.next()) {
    if (one->kind != 0x09 && one->kind != 0x0e) return one->kind;  // INFO_TS, INFO_DST
  }
  return 0;
}

/// Topics of the writers that a host announces. Samples may leave before their announcement.
std::map<EndpointGuid, std::string> topics_in(const std::vector<TappedPacket>& packets) {
  std::map<EndpointGuid, std::string> topics;
  for (const TappedPacket& packet : packets) {
    const auto rtps = packet.outgoing ? rtps_in(packet.bytes) : std::nullopt;
    if (!rtps) continue;
    for (const AnnouncedWriter& writer : announced_writers_in(*rtps)) {
      topics[writer.guid] = writer.topic.substr(std::string("rt/").size());
    }
  }
  return topics;
}

}  // namespace

std::vector<Sent> sent(const PacketTap& tap, std::int64_t since_ns) {
  const auto packets = tap.packets();
  auto topics = topics_in(packets);
  std::vector<Sent> all;
  std::set<EndpointGuid> old;  // participants
  for (const TappedPacket& packet : packets) {
    const auto rtps = packet.outgoing ? rtps_in(packet.bytes) : std::nullopt;
    if (!rtps) continue;
    const EndpointGuid participant = rtps->guid_of({});
    if (packet.time_ns <= since_ns) old.insert(participant);
    if (old.count(participant) != 0) continue;
    const auto sender = sender_in(rtps->message, rtps->bytes);
    const bool discovery = !sender || is_builtin(*sender);
    all.push_back({packet.time_ns, packet.bytes.size(), rtps->dscp, discovery, kind_of(*rtps),
                   discovery ? "" : topics[rtps->guid_of(*sender)]});
  }
  return all;
}

std::size_t announcements(const PacketTap& tap, std::int64_t since_ns) {
  std::size_t found = 0;
  for (const TappedPacket& packet : tap.packets()) {
    const auto rtps = packet.outgoing ? rtps_in(packet.bytes) : std::nullopt;
    if (!rtps || packet.time_ns <= since_ns) continue;
    for (const SamplePart& part : samples_in(*rtps)) {
      // SEDP's writers of publications and of subscriptions.
      if (part.writer == 0x000003c2 || part.writer == 0x000004c2) ++found;
    }
  }
  return found;
}

std::size_t count(const std::vector<Sent>& packets, const std::string& topic,
                  std::int64_t since_ns) {
  return static_cast<std::size_t>(
      std::count_if(packets.begin(), packets.end(), [&](const Sent& one) {
        const bool carries = one.kind == 0x15 || one.kind == 0x16;
        return one.time_ns > since_ns && one.topic == topic && carries;
      }));
}

}  // namespace tocsin
