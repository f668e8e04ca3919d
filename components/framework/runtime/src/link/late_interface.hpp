// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace tocsin {

/// Waits on a thread of its own until an address is on a running interface. The kernel tells of
/// changes (netlink); where it does not, a look once a second.
class LateInterface {
 public:
  /// `on_running` is called from that thread until it returns true; then the thread ends.
  LateInterface(std::string address, std::function<bool()> on_running);
  /// Waits for a running call.
  ~LateInterface();
  LateInterface(const LateInterface&) = delete;
  LateInterface& operator=(const LateInterface&) = delete;

 private:
  void watch();
  const std::string address_;
  const std::function<bool()> on_running_;
  const int stop_;     // eventfd
  const int changes_;  // netlink socket; -1: not allowed
  std::thread thread_;
};

}  // namespace tocsin
