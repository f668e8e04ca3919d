// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

namespace tocsin::doctor {

/// Local UDP ports in the text of /proc/net/udp.
[[nodiscard]] std::set<int> udp_ports(const std::string& proc_net_udp);

/// Participants of a DDS domain on this computer, counted by their unicast discovery ports
/// 7400 + 250 domain + 10 + 2 id (DDSI-RTPS 2.3, 9.6.1.1), ids 0 to 119.
[[nodiscard]] int participants(const std::set<int>& ports, int domain);

}  // namespace tocsin::doctor
