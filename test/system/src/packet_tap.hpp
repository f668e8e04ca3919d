// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tocsin {

/// A packet as it passed the interface.
struct TappedPacket {
  std::int64_t time_ns;  ///< since the epoch, by the kernel
  bool outgoing;
  std::vector<std::uint8_t> bytes;  ///< from the IP header on
};

/// Listens to all IP packets of an interface in the network namespace of a process.
class PacketTap {
 public:
  explicit PacketTap(pid_t process, const std::string& interface = "wlan0");
  ~PacketTap();
  PacketTap(const PacketTap&) = delete;
  PacketTap& operator=(const PacketTap&) = delete;

  /// False when the namespace or the packet socket could not be opened.
  [[nodiscard]] bool ok() const { return socket_ >= 0; }
  /// Whether these bytes were in any packet so far.
  [[nodiscard]] bool saw(const std::string& bytes) const;
  /// Multicast packets that came from the other side.
  [[nodiscard]] std::size_t multicasts() const;
  /// All so far.
  [[nodiscard]] std::vector<TappedPacket> packets() const;

 private:
  void run();
  int socket_ = -1;
  std::atomic<bool> stopping_{false};
  mutable std::mutex mutex_;
  std::vector<TappedPacket> packets_;
  std::thread thread_;
};

}  // namespace tocsin
