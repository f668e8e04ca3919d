// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/state_file.hpp"

namespace tocsin {

/// Keeps whether the emergency stop is pressed, so that the process that died and was restarted by
/// its launcher goes on saying it. A new launch starts afresh: what another parent process has left
/// is not read.
class RequestFile {
 public:
  /// An empty path keeps nothing.
  explicit RequestFile(std::string path) : file_(std::move(path)) {}
  /// False also when there is no file, it is damaged, or it is of another launch.
  [[nodiscard]] bool load() const;
  /// Written in place, so that only the first call needs room. False when it could not be written.
  [[nodiscard]] bool save(bool pressed);

 private:
  StateFile file_;
};

}  // namespace tocsin
