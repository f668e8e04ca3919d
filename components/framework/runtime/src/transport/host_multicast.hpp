// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {

/// The group that participants announce themselves to (RTPS 2.2 section 9.6.1.4).
inline constexpr const char* discovery_group = "239.255.0.1";
/// Its port in a domain (RTPS 2.2 section 9.6.1.1).
[[nodiscard]] constexpr std::uint16_t discovery_group_port(int domain) {
  return static_cast<std::uint16_t>(7400 + 250 * domain);
}

/// Interfaces other than `loopback` on which some program of this host is a member of `group`, by
/// index; `text` is that of /proc/net/igmp.
[[nodiscard]] std::vector<unsigned> interfaces_with_member(const std::string& text, in_addr group,
                                                           unsigned loopback);

/// Hears what programs of this host send to the discovery group, on whatever interface, and nothing
/// from other machines: the kernel drops that before it takes room.
///
/// Joins the group on loopback only, so nothing is told to any network. Where another program has
/// joined it, such as a default-configured participant on its interface, Linux lets every socket of
/// the group hear.
class HostMulticastReceiver {
 public:
  /// Throws EnvironmentError when the port cannot be shared, or what comes cannot be filtered.
  explicit HostMulticastReceiver(std::uint16_t port);
  ~HostMulticastReceiver() { stop(); }
  HostMulticastReceiver(const HostMulticastReceiver&) = delete;
  HostMulticastReceiver& operator=(const HostMulticastReceiver&) = delete;

  /// `on_datagram` is called by a thread of its own.
  void start(OnDatagram on_datagram);
  /// Returns when the thread has ended; for good.
  void stop();
  [[nodiscard]] bool is_running() const { return thread_.joinable(); }

 private:
  FileDescriptor socket_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Sends to the discovery group on the interfaces where another program of this host has joined it.
/// Nothing leaves the host: time to live is 0. It does not join: that would be told to the network,
/// and be taken by others who send at that instant for a program that listens.
class HostMulticastSender {
 public:
  /// `socket`: bound to a port, outlives it. Others know by the port that it is the same sender.
  explicit HostMulticastSender(const FileDescriptor& socket);
  /// A full socket loses the packet. Any thread.
  void send(const std::uint8_t* bytes, std::size_t size, std::uint16_t port);

 private:
  const FileDescriptor& socket_;
  unsigned loopback_;
};

}  // namespace tocsin
