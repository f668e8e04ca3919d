// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/state_file.hpp"
#include "foundation/time.hpp"
#include "kobuki_protocol/odometry.hpp"

namespace tocsin::kobuki {

/// Odometry, and when its last frame came.
struct OdometryMemory {
  OdometrySnapshot odometry;
  Time taken{};
};

/// Keeps odometry over a restart of the driver, so that it goes on from where it was and with the
/// motion in between, because the base's encoders and gyro went on. Valid for processes of one
/// parent (the launcher): a new run starts at zero.
class OdometryFile {
 public:
  /// An empty path keeps nothing.
  explicit OdometryFile(std::string path) : file_(std::move(path)) {}
  /// Empty when there is none, or it is of another run or damaged.
  [[nodiscard]] std::optional<OdometryMemory> load() const;
  /// False when it cannot be written; the one before is kept then.
  [[nodiscard]] bool save(const OdometryMemory& memory);

 private:
  StateFile file_;
};

}  // namespace tocsin::kobuki
