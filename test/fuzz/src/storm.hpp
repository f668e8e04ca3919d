// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "attacker.hpp"

namespace tocsin::fuzz {

/// How many packets of each sort.
struct StormSize {
  std::uint32_t mutated = 0;
  std::uint32_t random = 0;
  std::uint32_t structured = 0;
  unsigned seed = 1;
};
/// Sends them in a mixed order, no faster than sockets can take, to one socket after the other.
void send_storm(const Attacker& attacker, const StormSize& size);

/// What has become of processes that were attacked.
class Victims {
 public:
  explicit Victims(const std::vector<pid_t>& processes);
  /// One line for each that died, has grown by more than 64 MiB, or has a thread that spins. Takes
  /// a second for each process, 15 where it spins.
  [[nodiscard]] std::vector<std::string> complaints() const;

 private:
  std::vector<std::pair<pid_t, Vitals>> before_;
};

}  // namespace tocsin::fuzz
