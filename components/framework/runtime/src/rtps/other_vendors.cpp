// SPDX-License-Identifier: Apache-2.0
#include "rtps/other_vendors.hpp"

namespace tocsin {

void OtherVendors::hear(const std::uint8_t* packet, std::size_t size, std::uint32_t address) {
  constexpr std::size_t header_bytes = 20;  // RTPS 2.5, 9.4.4
  constexpr std::size_t vendor_at = 6;
  constexpr std::uint8_t eprosima = 0x0f;
  if (size < header_bytes) return;
  if (packet[vendor_at] == 1 && packet[vendor_at + 1] == eprosima) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  addresses_.insert(address);
}

bool OtherVendors::are_at(std::uint32_t address) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return addresses_.count(address) != 0;
}

}  // namespace tocsin
