// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace tocsin::fuzz {

using Packet = std::vector<std::uint8_t>;

struct NamedPacket {
  std::string name;
  Packet bytes;
};

/// Packets that crash Fast DDS 2.9.1, make it take gigabytes or walk for ever, whoever sends them.
[[nodiscard]] std::vector<NamedPacket> hostile_from_anybody();
/// An address to which answers are wanted.
struct Whereabouts {
  std::array<std::uint8_t, 4> address;
  std::uint16_t port;
};
/// The announcement of the participant that the others are from; of another one for each `number`
/// but zero.
[[nodiscard]] Packet hostile_announcement(const Whereabouts& here, std::uint32_t number = 0);
/// The same as from anybody, from a participant that has been announced.
[[nodiscard]] std::vector<NamedPacket> hostile_from_announced();
/// Says that the participant whose GUIDs begin with `prefix` leaves.
[[nodiscard]] Packet forged_disposal(const Packet& prefix);

/// A packet of known submessages with odd numbers in their fields.
[[nodiscard]] Packet structured_packet(std::mt19937& random);
/// Up to 1400 bytes of anything, half of them behind an RTPS header.
[[nodiscard]] Packet random_packet(std::mt19937& random);
/// Changes up to six places.
void mutate(Packet& packet, std::mt19937& random);
/// Packets of real traffic.
[[nodiscard]] const std::vector<Packet>& captured_packets();

}  // namespace tocsin::fuzz
