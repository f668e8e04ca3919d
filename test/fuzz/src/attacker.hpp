// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <netinet/in.h>
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hostile_packets.hpp"

namespace tocsin::fuzz {

/// Somebody with a UDP socket, in the network namespace of the victims.
class Attacker {
 public:
  /// `address`: where it sends from and hears; empty: any.
  explicit Attacker(const std::string& address = "");
  ~Attacker();
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// To every UDP socket that is bound in this network namespace but its own.
  void send_to_all(const Packet& packet) const;
  /// To one of them; `draw` says which.
  void send_to_one(const Packet& packet, std::size_t draw) const;
  /// Announces itself, and waits until somebody answers with an announcement of their own; returns
  /// the prefixes of all who do within `limit`.
  [[nodiscard]] std::vector<Packet> announced_by_others(std::chrono::milliseconds limit) const;
  /// The same, with another announcement of its own.
  [[nodiscard]] std::vector<Packet> answers_to(const Packet& announcement,
                                               std::chrono::milliseconds limit) const;

 private:
  int socket_;
  std::uint16_t port_ = 0;
  std::vector<sockaddr_in> targets_;
};

/// Where UDP sockets of this network namespace hear; those of any address on loopback.
[[nodiscard]] std::vector<sockaddr_in> bound_addresses();

/// How a process is.
struct Vitals {
  std::uint64_t resident_bytes = 0;
  /// How long the busiest thread since `before` ran or waited for a core.
  double busiest_thread_s = 0;
  std::vector<std::pair<int, double>> threads;  ///< all of them, with that time [s] so far
};
/// Nothing when it does not run.
[[nodiscard]] std::optional<Vitals> vitals_of(pid_t process, const Vitals& before = {});

}  // namespace tocsin::fuzz
