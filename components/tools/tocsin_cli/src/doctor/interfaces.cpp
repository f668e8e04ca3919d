// SPDX-License-Identifier: Apache-2.0
#include "interfaces.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <algorithm>
#include <array>

namespace tocsin::doctor {

std::vector<Interface> interfaces() {
  std::vector<Interface> found;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return found;
  for (const ifaddrs* it = first; it != nullptr; it = it->ifa_next) {
    if (it->ifa_addr == nullptr || it->ifa_addr->sa_family != AF_INET) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* address = reinterpret_cast<const sockaddr_in*>(it->ifa_addr);
    ::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size());
    found.push_back({it->ifa_name, text.data(), (it->ifa_flags & IFF_UP) != 0,
                     (it->ifa_flags & IFF_RUNNING) != 0});
  }
  ::freeifaddrs(first);
  return found;
}

Advice judge_address(const std::string& wanted, const std::vector<Interface>& interfaces) {
  const auto at = std::find_if(interfaces.begin(), interfaces.end(),
                               [&](const Interface& one) { return one.address == wanted; });
  if (at == interfaces.end()) return {Fitness::unknown, wanted + " is not an address here", ""};
  const std::string where = wanted + " on " + at->name;
  if (!at->up) {
    return {Fitness::bad, where + " is down", "ip link set " + at->name + " up"};
  }
  if (!at->carrier) {
    return {Fitness::bad, where + " has no carrier",
            "join the network: until then only topics of the host itself work"};
  }
  return {Fitness::good, where + " is up, with carrier", ""};
}

Advice judge_loopback(const std::vector<Interface>& interfaces) {
  const Advice advice = judge_address("127.0.0.1", interfaces);
  if (advice.fitness != Fitness::unknown) return advice;
  return {Fitness::bad, "loopback has no address: host topics cannot go between processes",
          "ip link set lo up"};
}

}  // namespace tocsin::doctor
