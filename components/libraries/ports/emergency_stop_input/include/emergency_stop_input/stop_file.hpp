// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "emergency_stop_input/emergency_stop_latch.hpp"
#include "emergency_stop_input/link_stop_view.hpp"
#include "foundation/state_file.hpp"

namespace tocsin {

/// What a process that obeys the emergency stop keeps for its successor.
struct StopMemory {
  EmergencyStopLatch::Memory latch;
  LinkStopView::Memory link;
};

/// Keeps which emergency stops stand, so that a process that died and was restarted by its launcher
/// stands still where it hears nobody. A new launch starts afresh: what another parent process has
/// left is not read.
class StopFile {
 public:
  /// An empty path keeps nothing.
  explicit StopFile(std::string path) : file_(std::move(path)) {}
  /// Nothing stands when there is no file, it is damaged, or it is of another launch.
  [[nodiscard]] StopMemory load() const;
  /// Writes what has changed; the first call takes the room of the file. False, once, when it could
  /// not be written; it is tried again with each call.
  [[nodiscard]] bool save(const StopMemory& memory);

 private:
  StateFile file_;
  std::optional<StopMemory> saved_;
  bool failed_ = false;
};

}  // namespace tocsin
