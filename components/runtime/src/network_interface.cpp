// SPDX-License-Identifier: Apache-2.0
#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>

#include <chrono>
#include <memory>
#include <thread>

#include "runtime/fast_dds_bus.hpp"

namespace tocsin {
namespace {

bool is_running(const ifaddrs& entry, in_addr_t address) {
  if (entry.ifa_addr == nullptr || entry.ifa_addr->sa_family != AF_INET) return false;
  const auto* inet = reinterpret_cast<const sockaddr_in*>(entry.ifa_addr);
  return inet->sin_addr.s_addr == address && (entry.ifa_flags & IFF_RUNNING) != 0;
}

bool any_running(in_addr_t address) {
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return false;
  const std::unique_ptr<ifaddrs, decltype(&freeifaddrs)> owner(list, freeifaddrs);
  for (const ifaddrs* entry = list; entry != nullptr; entry = entry->ifa_next) {
    if (is_running(*entry, address)) return true;
  }
  return false;
}

}  // namespace

bool wait_for_interface(const std::string& address, Duration timeout) {
  const in_addr_t wanted = inet_addr(address.c_str());
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (!any_running(wanted)) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

}  // namespace tocsin
