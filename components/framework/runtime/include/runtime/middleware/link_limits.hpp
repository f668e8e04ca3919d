// SPDX-License-Identifier: Apache-2.0
// What every router's participants do on the link, whatever the profiles say. They find their peers
// by unicast only.
#pragma once

#include <cstdint>

namespace tocsin {

/// [byte] RTPS messages that fit one 1500-byte IP packet: IP never fragments on the radio.
constexpr std::uint32_t radio_message_bytes = 1400;

/// [s] Patient: a peer that was out of reach for minutes is still known, and hears at once.
constexpr double link_lease_s = 300;

}  // namespace tocsin
