// SPDX-License-Identifier: Apache-2.0
#include "foundation/network_interface.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <memory>

namespace tocsin {
namespace {

bool is_running(const ifaddrs& entry, const in_addr& address) {
  if (entry.ifa_addr == nullptr || entry.ifa_addr->sa_family != AF_INET) return false;
  const auto* inet = reinterpret_cast<const sockaddr_in*>(entry.ifa_addr);
  return inet->sin_addr.s_addr == address.s_addr && (entry.ifa_flags & IFF_RUNNING) != 0;
}

}  // namespace

bool interface_is_running(const std::string& address) {
  in_addr wanted{};
  ifaddrs* list = nullptr;
  if (::inet_pton(AF_INET, address.c_str(), &wanted) != 1 || ::getifaddrs(&list) != 0) return false;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(list, freeifaddrs);
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    if (is_running(*entry, wanted)) return true;
  }
  return false;
}

}  // namespace tocsin
