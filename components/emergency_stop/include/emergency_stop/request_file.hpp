// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// Keeps whether the emergency stop is pressed, so that the process that died and was restarted by
/// its launcher does not release it. A new launch starts afresh: what another parent process has
/// left is not read.
class RequestFile {
 public:
  /// An empty path keeps nothing.
  explicit RequestFile(std::string path) : path_(std::move(path)) {}
  /// Empty when there is no file, it is damaged, or it is of another launch.
  [[nodiscard]] std::optional<bool> load() const;
  /// Replaces the file in one step. False when it could not be written.
  [[nodiscard]] bool save(bool pressed) const;

 private:
  std::string path_;
};

}  // namespace tocsin
