// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tocsin {

/// The RTPS message in an IP packet. Points into the packet.
struct RtpsPacket {
  std::uint16_t destination_port = 0;
  const std::uint8_t* message = nullptr;
  std::size_t bytes = 0;
};

/// Nothing when the packet is no UDP packet that begins with RTPS, or a later IP fragment.
[[nodiscard]] std::optional<RtpsPacket> rtps_in(const std::vector<std::uint8_t>& packet);

/// A sample, or the part of it that one packet holds.
struct SamplePart {
  std::uint32_t writer = 0;  ///< entity id, its first byte the highest
  std::int64_t number = 0;   ///< of that writer
  bool first = true;
  bool last = true;
  const std::uint8_t* payload = nullptr;  ///< encapsulation header included, if it is the first
  std::size_t bytes = 0;
};

/// Each DATA and DATA_FRAG of a message that has little endian numbers.
[[nodiscard]] std::vector<SamplePart> samples_in(const RtpsPacket& packet);

}  // namespace tocsin
