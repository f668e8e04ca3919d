// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hostile_packets.hpp"

namespace tocsin::fuzz {

/// Somebody with a UDP socket on loopback, in the network namespace of the victims.
class Attacker {
 public:
  Attacker();
  ~Attacker();
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// To every UDP port that is bound in this network namespace but its own.
  void send_to_all(const Packet& packet) const;
  /// Announces itself, and waits until somebody answers with an announcement of their own; returns
  /// the prefixes of all who do within `limit`.
  [[nodiscard]] std::vector<Packet> announced_by_others(std::chrono::milliseconds limit) const;

 private:
  int socket_;
  std::uint16_t port_ = 0;
  std::vector<std::uint16_t> targets_;
};

/// UDP ports that are bound in this network namespace.
[[nodiscard]] std::vector<std::uint16_t> bound_ports();

/// How a process is.
struct Vitals {
  std::uint64_t resident_bytes = 0;
  double busiest_thread_s = 0;  ///< CPU time of the thread that had most since `before`
  std::vector<std::pair<int, double>> threads;  ///< all of them, with their CPU time [s] so far
};
/// Nothing when it does not run.
[[nodiscard]] std::optional<Vitals> vitals_of(pid_t process, const Vitals& before = {});

}  // namespace tocsin::fuzz
