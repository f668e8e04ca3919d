// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "message_builder.hpp"

namespace tocsin::rtps_filter {

struct Captured {
  Source from;
  Bytes bytes;
};

/// Packets of real traffic: address, port and bytes in hexadecimal, one a line.
inline std::vector<Captured> read_captures(const std::string& name) {
  std::ifstream file(std::string(CAPTURES) + "/" + name + ".txt");
  std::vector<Captured> packets;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    Captured packet;
    std::string address;
    std::string digits;
    words >> address >> packet.from.port >> digits;
    std::istringstream octets(address);
    for (std::string octet; std::getline(octets, octet, '.');) {
      packet.from.address =
          packet.from.address << 8U | static_cast<std::uint32_t>(std::stoul(octet));
    }
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
      packet.bytes.push_back(
          static_cast<std::uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
    }
    packets.push_back(packet);
  }
  if (packets.empty()) throw std::runtime_error("no captures of " + name);
  return packets;
}

}  // namespace tocsin::rtps_filter
