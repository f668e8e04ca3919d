// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/state_file.hpp"
#include "navigator/odometry_localiser.hpp"

namespace tocsin {

/// Keeps a localiser's memory in a file, so that a navigator that died and was restarted by its
/// launcher knows where the vehicle is. A new launch starts afresh: what another parent process
/// has left is not read.
class LocaliserFile {
 public:
  /// An empty path keeps nothing.
  explicit LocaliserFile(std::string path) : file_(std::move(path)) {}

  /// Empty when there is no file, it is damaged, or it is of another launch.
  [[nodiscard]] std::optional<OdometryLocaliser::Memory> load() const;
  /// False when it could not be written; the one before is kept then.
  [[nodiscard]] bool save(const OdometryLocaliser::Memory& memory);

 private:
  StateFile file_;
};

}  // namespace tocsin
