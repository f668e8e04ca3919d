// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tocsin::interop {

/// Listens to the IP packets that arrive on `interface` in the network namespace of a process.
class CableTap {
 public:
  CableTap(pid_t process, const std::string& interface);
  ~CableTap();
  CableTap(const CableTap&) = delete;
  CableTap& operator=(const CableTap&) = delete;

  /// False when the namespace or the packet socket could not be opened.
  [[nodiscard]] bool ok() const { return socket_ >= 0; }
  /// Who sent each packet so far: the vendor of an RTPS message, such as "1.15", or "igmp", or "ip"
  /// and the number of the protocol.
  [[nodiscard]] std::vector<std::string> senders() const;

 private:
  void run();
  int socket_ = -1;
  std::atomic<bool> stopping_{false};
  mutable std::mutex mutex_;
  std::vector<std::string> senders_;
  std::thread thread_;
};

}  // namespace tocsin::interop
