// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "transport/socket_wait.hpp"
#include "watch/activity.hpp"

namespace tocsin {

/// One port of a transport: what its thread is seen to do, and its socket once that is open.
struct Reception {
  std::shared_ptr<Activity> activity;
  std::shared_ptr<const SocketWait> socket;
};

/// The receptions of a transport, by port. Any thread.
class Receptions {
 public:
  void open(std::uint32_t port);
  /// Its socket is there.
  void opened(std::uint32_t port);
  void close(std::uint32_t port);
  /// Empty for a port that is not open.
  [[nodiscard]] Reception at(std::uint32_t port);

 private:
  std::mutex mutex_;
  std::map<std::uint32_t, Reception> by_port_;
};

}  // namespace tocsin
