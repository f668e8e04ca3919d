// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>

namespace tocsin {

/// Addresses from which participants of other vendors than eProsima have spoken: they know nothing
/// of our pieces of messages (MessagePieces). Thread-safe.
class OtherVendors {
 public:
  /// Notes who has made a packet that the filter has let through, as its RTPS header says.
  /// `address`: IPv4 of the sender; of few, as only configured peers are let through.
  void hear(const std::uint8_t* packet, std::size_t size, std::uint32_t address);
  [[nodiscard]] bool are_at(std::uint32_t address) const;

 private:
  mutable std::mutex mutex_;
  std::set<std::uint32_t> addresses_;
};

}  // namespace tocsin
