// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// IPv4 of a locator, host byte order.
[[nodiscard]] std::uint32_t ipv4_of(const eprosima::fastdds::rtps::Locator_t& locator);

/// A UDP socket at an address and port (0: any), which need not be on an interface yet: that may
/// come later. Empty, with errno, when that is refused.
[[nodiscard]] FileDescriptor radio_socket(const std::string& address, std::uint16_t port);

/// A UDP socket bound to the address of the radio's interface. Any thread sends.
class RadioSocket {
 public:
  explicit RadioSocket(const std::string& address) : socket_(radio_socket(address, 0)) {}

  [[nodiscard]] bool usable() const { return static_cast<bool>(socket_); }
  /// A packet of `size` bytes and `more` behind them. A full socket loses it, as the radio would.
  [[nodiscard]] bool send(const std::uint8_t* bytes, std::size_t size,
                          const eprosima::fastdds::rtps::Locator_t& to, int dscp,
                          const std::vector<std::uint8_t>& more = {}) const;

 private:
  FileDescriptor socket_;
};

}  // namespace tocsin
