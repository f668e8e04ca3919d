// SPDX-License-Identifier: Apache-2.0
#include "hostile_packets.hpp"

#include <algorithm>
#include <array>

#include "captures.hpp"
#include "message_builder.hpp"

namespace tocsin::fuzz {
namespace {

using namespace rtps_filter;

constexpr char attacker = 'm';
constexpr std::uint32_t spdp_reader = 0x000100c7;
constexpr std::uint32_t sedp_reader = 0x000003c7;
constexpr std::uint32_t eprosima = 0x010f;
constexpr std::uint32_t huge = 0xffffffff;
constexpr std::uint32_t many = 1U << 25U;

Packet data(const Wire& content, std::uint32_t flags) {
  return Message(attacker).add(0x15, flags, content.bytes()).bytes();
}

Packet odd_announcement(std::uint32_t id, const Wire& value) {
  return announcement(attacker, Wire().parameter(id, value.bytes()));
}

/// All are the first sample of their writer: whichever comes first is read.
Packet odd_endpoint(std::uint32_t id, const Wire& value) {
  const Wire list =
      Wire().parameter(0x5a, guid_of(attacker, 0x00000103)).parameter(id, value.bytes()).sentinel();
  return data(data_head(sedp_writer, 1, 16, sedp_reader).raw(parameters_payload(list)), with_data);
}

/// DATA_FRAG, the fixed part.
Wire fragment_head(std::uint32_t reader, std::uint32_t writer, std::uint32_t octets,
                   std::uint32_t sample_bytes) {
  return data_head(writer, 1, octets, reader).u32(1).u16(1).u16(1000).u32(sample_bytes);
}

Packet fragment(const Wire& content, std::uint32_t flags) {
  return Message(attacker).add(0x16, flags, content.bytes()).bytes();
}

/// Numbers of the attacker's writer of discovery.
Packet numbers(std::uint32_t kind, const Wire& content) {
  const Wire ids = Wire().entity(sedp_reader).entity(sedp_writer);
  return Message(attacker).add(kind, 0, Wire(ids).raw(content.bytes()).bytes()).bytes();
}

/// Values at the edges of what fields may hold.
std::uint32_t odd(std::mt19937& random) {
  constexpr std::array<std::uint32_t, 12> edges{0,      1,      2,          16,         28,   256,
                                                0x7fff, 0xffff, 0x7fffffff, 0x80000000, huge, 1400};
  return random() % 3 == 0 ? static_cast<std::uint32_t>(random()) : edges[random() % edges.size()];
}

std::int64_t odd_number(std::mt19937& random) {
  const auto high = random() % 3 == 0 ? odd(random) : 0;
  return static_cast<std::int64_t>(std::uint64_t{high} << 32U | odd(random));
}

std::uint32_t odd_entity(std::mt19937& random) {
  constexpr std::array<std::uint32_t, 12> known{0,          0x000100c2, 0x000100c7, 0x000003c2,
                                                0x000003c7, 0x000004c2, 0x000004c7, 0x000200c2,
                                                0x000200c7, 0x000201c3, 0x000201c4, 0x00000103};
  return known[random() % known.size()];
}

Wire odd_parameters(std::mt19937& random) {
  constexpr std::array<std::uint32_t, 16> known{0x02, 0x05,   0x07,   0x29,  0x2c, 0x32,
                                                0x35, 0x50,   0x59,   0x5a,  0x62, 0x70,
                                                0x71, 0x1001, 0x0073, 0x8006};
  Wire list;
  for (std::size_t i = random() % 6; i > 0; --i) {
    Wire value;
    for (std::size_t words = random() % 7; words > 0; --words) value.u32(odd(random));
    list.parameter(known[random() % known.size()], value.bytes());
  }
  return random() % 4 == 0 ? list : list.sentinel();
}

Wire odd_content(std::uint32_t kind, std::mt19937& random) {
  Wire content;
  switch (kind) {
    case 0x15:
    case 0x16:
      content = data_head(odd_entity(random), odd_number(random),
                          random() % 2 == 0 ? (kind == 0x15 ? 16 : 28) : odd(random) & 0xffffU,
                          odd_entity(random));
      if (kind == 0x16) content.u32(odd(random)).u16(1).u16(odd(random)).u32(odd(random));
      if (random() % 2 == 0) content.raw({0, 3, 0, 0});
      return content.raw(odd_parameters(random).bytes());
    case 0x06:
    case 0x07:
    case 0x08:
    case 0x12:
      return content.entity(odd_entity(random))
          .entity(odd_entity(random))
          .number(odd_number(random))
          .number(odd_number(random))
          .u32(odd(random))
          .u32(1);
    default:
      for (std::size_t words = random() % 8; words > 0; --words) content.u32(odd(random));
      return content;
  }
}

}  // namespace

std::vector<NamedPacket> hostile_from_anybody() {
  const Bytes list = Wire().parameter(0x70, Bytes(16, 7)).sentinel().bytes();
  const Wire token = Wire().text("DDS:Auth:PKI-DH:1.0").u32(many).u32(0);
  const Wire binary_token = Wire().text("DDS:Auth:PKI-DH:1.0").u32(0).u32(1).text("x").u32(huge);
  return {
      {"statistics submessage too short",
       Message(attacker, eprosima).add(0x80, 0, Bytes(4, 0)).bytes()},
      {"statistics submessage not at the end",
       Message(attacker, eprosima).add(0x80, 0, Bytes(56, 0)).add(0x01, 0, {}).bytes()},
      {"DATA_FRAG with inline QoS and octetsToInlineQos 0",
       fragment(fragment_head(spdp_reader, spdp_writer, 0, 3000).raw(list).zeros(1000), with_qos)},
      {"DATA with octetsToInlineQos beyond the submessage",
       Message(attacker)
           .add(0x15, with_data, data_head(spdp_writer, 1, 100, spdp_reader).zeros(4).bytes())
           .add(0x01, 0, Bytes(200, 0))
           .bytes()},
      {"participant's name of 2^32-1 bytes", odd_announcement(0x62, Wire().u32(huge).u32(0))},
      {"2^32-1 properties", odd_announcement(0x59, Wire().u32(huge).u32(0))},
      {"property of 2^32-1 bytes", odd_announcement(0x59, Wire().u32(1).u32(huge).u32(0))},
      {"identity token of 2^25 properties", odd_announcement(0x1001, token)},
      {"identity token with a value of 2^32-1 bytes", odd_announcement(0x1001, binary_token)},
      {"identity token with a class of 2^32-1 bytes",
       odd_announcement(0x1001, Wire().u32(huge).u32(0).u32(0))},
      {"permissions token of 2^25 properties", odd_announcement(0x1002, token)},
  };
}

Packet hostile_announcement(const Whereabouts& here, std::uint32_t number) {
  constexpr std::uint32_t endpoints_of_discovery = 0x00000c3f;
  const Bytes address(here.address.begin(), here.address.end());
  const Bytes locator = Wire().u32(1).u32(here.port).zeros(12).raw(address).bytes();
  const Wire list = Wire()
                        .parameter(0x15, {2, 1, 0, 0})
                        .parameter(0x16, {1, 3, 0, 0})
                        .parameter(0x58, Wire().u32(endpoints_of_discovery).bytes())
                        .parameter(0x02, Wire().u32(1000).u32(0).bytes())
                        .parameter(0x31, locator)
                        .parameter(0x32, locator);
  Packet packet = announcement(attacker, list);
  const std::array<std::uint8_t, 4> digits{
      static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U),
      static_cast<std::uint8_t>(number >> 16U), static_cast<std::uint8_t>(number >> 24U)};
  if (number == 0) return packet;
  constexpr std::size_t prefix_at = 8;  // in the header, and again in the payload's GUID
  constexpr std::size_t guid_at = 20 + 4 + 20 + 4 + 4;
  std::copy(digits.begin(), digits.end(), packet.begin() + prefix_at);
  std::copy(digits.begin(), digits.end(), packet.begin() + guid_at);
  return packet;
}

std::vector<NamedPacket> hostile_from_announced() {
  constexpr std::int64_t far = std::int64_t{1} << 40U;
  constexpr std::int64_t farthest = std::int64_t{1} << 62U;
  return {
      {"GAP over 2^62 numbers", numbers(0x08, Wire().number(1).number(farthest).u32(0))},
      {"HEARTBEAT with first = last = 2^40", numbers(0x07, Wire().number(far).number(far).u32(1))},
      {"DATA_FRAG of a sample of 4 GB",
       fragment(fragment_head(sedp_reader, sedp_writer, 28, huge).zeros(1000), 0)},
      {"2^32-1 data representations", odd_endpoint(0x73, Wire().u32(huge).u32(0))},
      {"2^32-1 domains of data sharing", odd_endpoint(0x8006, Wire().u32(huge).u32(0))},
      {"2^32-1 partitions", odd_endpoint(0x29, Wire().u32(huge).u32(0))},
      {"topic name of 2^32-1 bytes", odd_endpoint(0x05, Wire().u32(huge).u32(0))},
  };
}

Packet forged_disposal(const Packet& prefix) {
  Packet packet = departure(attacker, attacker);
  // The attacker's prefix is one letter, twelve times; nothing else in the packet is.
  std::size_t next = 0;
  for (std::uint8_t& octet : packet) {
    if (octet == attacker) octet = prefix[next++ % prefix.size()];
  }
  return packet;
}

Packet structured_packet(std::mt19937& random) {
  constexpr std::array<std::uint32_t, 15> kinds{0x15, 0x15, 0x15, 0x16, 0x07, 0x08, 0x06, 0x12,
                                                0x13, 0x09, 0x0e, 0x0c, 0x80, 0x31, 0x33};
  constexpr std::array<std::uint32_t, 3> vendors{0x010f, 0x0103, 0x0101};
  Message message(static_cast<char>('a' + random() % 4), vendors[random() % vendors.size()]);
  for (std::size_t i = 1 + random() % 4; i > 0; --i) {
    const std::uint32_t kind = kinds[random() % kinds.size()];
    message.add(kind, static_cast<std::uint32_t>(random() % 16), odd_content(kind, random).bytes());
  }
  return message.bytes();
}

Packet random_packet(std::mt19937& random) {
  Packet packet = random() % 2 == 0 ? Packet() : Message(attacker, eprosima).bytes();
  const std::size_t size = random() % 1380;
  while (packet.size() < size) packet.push_back(static_cast<std::uint8_t>(random()));
  return packet;
}

void mutate(Packet& packet, std::mt19937& random) {
  for (std::size_t i = 1 + random() % 6; i > 0 && packet.size() > 4; --i) {
    const std::size_t at = random() % packet.size();
    const auto place = packet.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random() % 4) {
      case 0:
        *place = static_cast<std::uint8_t>(random());
        break;
      case 1:
        *place = random() % 2 == 0 ? 0xff : 0;
        break;
      case 2:
        packet.erase(place, std::min(place + 4, packet.end()));
        break;
      default:
        packet.insert(place, random() % 9, static_cast<std::uint8_t>(random()));
    }
  }
}

const std::vector<Packet>& captured_packets() {
  static const std::vector<Packet> all = [] {
    std::vector<Packet> packets;
    for (const char* vendor : {"fast_dds", "cyclone", "cyclone_fragments", "secured"}) {
      for (const Captured& packet : read_captures(vendor)) packets.push_back(packet.bytes);
    }
    return packets;
  }();
  return all;
}

}  // namespace tocsin::fuzz
