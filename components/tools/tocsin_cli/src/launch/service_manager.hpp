// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/datagram_socket.hpp"
#include "foundation/time.hpp"

namespace tocsin::cli {

/// The service manager that started this process, told how it is by the protocol of sd_notify(3):
/// one datagram to the socket `$NOTIFY_SOCKET` for each state. Does nothing where there is none.
class ServiceManager {
 public:
  /// Takes `$NOTIFY_SOCKET`, `$WATCHDOG_USEC` and `$WATCHDOG_PID` out of the environment: they are
  /// not for the processes of the launch.
  ServiceManager();

  /// All processes are started.
  void ready(const std::string& status);
  /// This process begins to end.
  void stopping();
  /// Answers the watchdog of the service when half of its time is over (sd_watchdog_enabled(3)).
  void alive(Time now);
  /// When `alive` is to be called next; `never` without a watchdog.
  [[nodiscard]] Time next_sign() const { return next_sign_; }

 private:
  void send(const std::string& state);
  std::string address_;
  std::optional<DatagramSocket> socket_;  ///< none: nobody is told
  Duration sign_period_{};                ///< 0: there is no watchdog
  Time next_sign_ = never;
};

}  // namespace tocsin::cli
