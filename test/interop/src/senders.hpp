// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "packet_tap.hpp"

namespace tocsin::interop {

/// Who sent each packet that has arrived there: the vendor of an RTPS message, such as "1.15", or
/// "igmp", or "ip" and the number of the protocol.
[[nodiscard]] std::vector<std::string> senders(const PacketTap& tap);

}  // namespace tocsin::interop
