// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tocsin::interop {

/// Where a participant of Cyclone DDS lives, and as whom.
struct CycloneIdentity {
  int domain = 0;
  std::string address;  ///< IPv4 of its interface, and of our routers
  std::string enclave;  ///< folder of its identity, as `tocsin keystore add` makes it; empty: none
};

/// For a while it writes the position of a vehicle and the goals of a station as fast as ours do,
/// with `mark` in each, and reads both. Returns how many it has read. Once in a process, as Cyclone
/// DDS takes its settings from the environment. Throws std::runtime_error when it cannot be made.
[[nodiscard]] std::size_t speak_as_cyclone(const CycloneIdentity& who, const std::string& mark,
                                           std::chrono::milliseconds time);

}  // namespace tocsin::interop
