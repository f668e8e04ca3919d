// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace tocsin {

/// Waits on a thread of its own until one of some addresses is on a running interface. The kernel
/// tells of changes (netlink); where it does not, a look once a second.
class LateInterface {
 public:
  /// `on_running` is called from that thread until it returns true; then the thread ends.
  LateInterface(std::vector<std::string> addresses, std::function<bool()> on_running);
  /// Whether one of them is on a running interface now.
  [[nodiscard]] static bool any_runs(const std::vector<std::string>& addresses);
  /// Waits for a running call.
  ~LateInterface();
  LateInterface(const LateInterface&) = delete;
  LateInterface& operator=(const LateInterface&) = delete;

 private:
  void watch();
  const std::vector<std::string> addresses_;
  const std::function<bool()> on_running_;
  const int stop_;     // eventfd
  const int changes_;  // netlink socket; -1: not allowed
  std::thread thread_;
};

}  // namespace tocsin
