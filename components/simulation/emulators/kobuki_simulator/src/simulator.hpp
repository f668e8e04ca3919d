// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "foundation/datagram_socket.hpp"
#include "options.hpp"
#include "pseudo_terminal.hpp"
#include "script.hpp"
#include "simulated_base.hpp"

namespace tocsin::kobuki {

/// The simulated base in real time: one thread, one epoll, a timer, signals.
class Simulator {
 public:
  /// Throws ConfigError or EnvironmentError.
  explicit Simulator(const Options& options);
  /// Until SIGTERM or SIGINT. Removes link and sockets at the end.
  void run();

 private:
  void watch(int descriptor);
  void arm_timer(Time at);
  void read_terminal(Time now);
  void read_control(Time now);
  void step(Time now);
  void play_script(Time now);
  void handle_cable(Time now);
  void step_laser(Time now);
  [[nodiscard]] std::string obey(const std::string& line, Time now);
  void report(Time now);
  void save(Time now);
  [[nodiscard]] Time next_wake() const;

  Options options_;
  laser::Room room_;
  SimulatedBase base_;
  std::optional<LaserTerminal> laser_;
  Script script_;
  std::optional<PseudoTerminal> terminal_;
  bool was_in_use_ = false;
  DatagramSocket position_;
  std::unique_ptr<DatagramSocket> control_;
  FileDescriptor epoll_;
  FileDescriptor timer_;
  FileDescriptor signals_;
  Time next_report_ = Time::min();
  Time next_save_ = Time::min();
  bool saved_ = true;  // the last time
};

}  // namespace tocsin::kobuki
