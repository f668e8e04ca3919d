// SPDX-License-Identifier: Apache-2.0
#include "domain_ports.hpp"

#include <sstream>

namespace tocsin::doctor {

std::set<int> udp_ports(const std::string& proc_net_udp) {
  std::set<int> ports;
  std::istringstream lines(proc_net_udp);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string slot;
    std::string local;
    words >> slot >> local;
    const std::size_t colon = local.find(':');
    if (colon == std::string::npos) continue;
    ports.insert(static_cast<int>(std::strtol(local.c_str() + colon + 1, nullptr, 16)));
  }
  return ports;
}

int participants(const std::set<int>& ports, int domain) {
  constexpr int port_base = 7400;
  constexpr int domain_gain = 250;
  constexpr int unicast_offset = 10;
  constexpr int participant_gain = 2;
  constexpr int ids = 120;
  int count = 0;
  for (int id = 0; id < ids; ++id) {
    const int port = port_base + domain_gain * domain + unicast_offset + participant_gain * id;
    count += static_cast<int>(ports.count(port));
  }
  return count;
}

}  // namespace tocsin::doctor
