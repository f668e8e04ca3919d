// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "emergency_stop_input/emergency_stop_latch.hpp"
#include "foundation/state_file.hpp"

namespace tocsin {

/// Keeps which emergency stops stand, so that a process that died and was restarted by its launcher
/// stands still where it hears nobody. A new launch starts afresh: what another parent process has
/// left is not read.
class StopFile {
 public:
  using Memory = EmergencyStopLatch::Memory;

  /// An empty path keeps nothing.
  explicit StopFile(std::string path) : file_(std::move(path)) {}
  /// Nothing stands when there is no file, it is damaged, or it is of another launch.
  [[nodiscard]] Memory load() const;
  /// Writes what has changed; the first call takes the room of the file. False, once, when it could
  /// not be written; it is tried again with each call.
  [[nodiscard]] bool save(const Memory& memory);

 private:
  StateFile file_;
  std::optional<Memory> saved_;
  bool failed_ = false;
};

}  // namespace tocsin
