// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

/// A DDS peer that belongs to no launch: a process of its own in the network of another one. It is
/// killed in the end, without a chance to say anything.
class Peer {
 public:
  /// Does `job` there, on a bus of these domains; the job should not end.
  Peer(pid_t process, const BusOptions& domains, const std::function<void(Bus&)>& job);
  /// The same without a bus.
  Peer(pid_t process, const std::function<void()>& job);
  ~Peer();
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void kill();
  /// It computes and hears nothing until it is resumed.
  void stop();
  void resume();

 private:
  pid_t pid_;
};

/// Writes every velocity of the wheels to a file: wall time [s] and speed [m/s].
[[nodiscard]] std::function<void(Bus&)> watch_wheels(const std::string& file);
/// When, by that file, the vehicle last moved faster than 1 cm/s [s since the epoch]; 0 never.
[[nodiscard]] double last_moved(const std::string& file);
/// When the file was last written [s since the epoch], so that silence is not taken for standing.
[[nodiscard]] double last_seen(const std::string& file);

}  // namespace tocsin
