// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/Locator.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tocsin {

/// IPv4 of a locator, host byte order.
[[nodiscard]] std::uint32_t ipv4_of(const eprosima::fastrtps::rtps::Locator_t& locator);

/// A UDP socket bound to the address of the radio's interface. Any thread sends.
class RadioSocket {
 public:
  explicit RadioSocket(const std::string& address);
  ~RadioSocket();
  RadioSocket(const RadioSocket&) = delete;
  RadioSocket& operator=(const RadioSocket&) = delete;

  [[nodiscard]] bool usable() const { return usable_; }
  /// A packet of `size` bytes and `more` behind them. A full socket loses it, as the radio would.
  [[nodiscard]] bool send(const std::uint8_t* bytes, std::size_t size,
                          const eprosima::fastrtps::rtps::Locator_t& to, int dscp,
                          const std::vector<std::uint8_t>& more = {}) const;

 private:
  int descriptor_;
  bool usable_ = false;
};

}  // namespace tocsin
