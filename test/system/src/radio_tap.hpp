// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace tocsin {

/// Listens to all IP packets on wlan0 in the network namespace of a process.
class RadioTap {
 public:
  explicit RadioTap(pid_t process);
  ~RadioTap();
  RadioTap(const RadioTap&) = delete;
  RadioTap& operator=(const RadioTap&) = delete;

  /// False when the namespace or the packet socket could not be opened.
  [[nodiscard]] bool ok() const { return socket_ >= 0; }
  /// Whether these bytes were in any packet so far.
  [[nodiscard]] bool saw(const std::string& bytes) const;
  [[nodiscard]] std::size_t packets() const { return packets_; }
  [[nodiscard]] std::size_t multicasts() const { return multicasts_; }

 private:
  void run();
  int socket_ = -1;
  std::atomic<bool> stopping_{false};
  std::atomic<std::size_t> packets_{0};
  std::atomic<std::size_t> multicasts_{0};
  mutable std::mutex mutex_;
  std::string bytes_;
  std::thread thread_;
};

}  // namespace tocsin
