// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/Locator.h>
#include <netinet/in.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// Where the second path of a router goes.
struct SecondRadioPlace {
  std::string address;                   ///< IPv4 of its interface, which may come later
  std::vector<std::string> peers;        ///< IPv4 of the peers by this path
  std::vector<std::string> first_peers;  ///< the same peers by the first path, in the same order
};

/// Receives what the peers send by the second path. Fast DDS knows the first one alone: a peer is
/// where its first address is, and its ports are the same on both paths.
class SecondRadio {
 public:
  using Locator = eprosima::fastrtps::rtps::Locator_t;
  /// Called by a thread of the port's own.
  using OnDatagram = std::function<void(const std::uint8_t*, std::size_t, const sockaddr_in& from)>;

  explicit SecondRadio(const SecondRadioPlace& place);
  ~SecondRadio();
  SecondRadio(const SecondRadio&) = delete;
  SecondRadio& operator=(const SecondRadio&) = delete;

  /// Throws EnvironmentError when the port is taken there.
  void start(std::uint16_t port, OnDatagram on_datagram);
  /// Returns when the port's thread has ended.
  void stop(std::uint16_t port);

  /// A peer's place by the other path; nothing when it is no peer's on that one.
  [[nodiscard]] std::optional<Locator> second_of(const Locator& first) const;
  [[nodiscard]] std::optional<Locator> first_of(const Locator& second) const;
  [[nodiscard]] bool is_second(std::uint32_t address) const { return firsts_.count(address) != 0; }
  [[nodiscard]] const std::string& address() const { return address_; }

 private:
  struct Port {
    FileDescriptor socket;
    std::atomic<bool> stopping{false};
    std::thread thread;
  };
  static void run(const Port& port, const OnDatagram& on_datagram);

  const std::string address_;
  std::map<std::uint32_t, std::uint32_t> seconds_;  ///< addresses, host order, by the first ones
  std::map<std::uint32_t, std::uint32_t> firsts_;
  std::map<std::uint16_t, std::unique_ptr<Port>> ports_;
};

}  // namespace tocsin
