// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

namespace tocsin::interop {

/// Waits for a condition of the world outside.
template <class Condition>
bool within(std::chrono::milliseconds limit, const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// The same with all the patience of a busy computer.
template <class Condition>
bool eventually(const Condition& condition) {
  return within(std::chrono::seconds(15), condition);
}

/// A payload as it arrives in a packet, where RTPS pads it to a multiple of four bytes.
inline std::vector<std::uint8_t> padded(std::vector<std::uint8_t> payload) {
  payload.resize((payload.size() + 3) / 4 * 4);
  return payload;
}

}  // namespace tocsin::interop
