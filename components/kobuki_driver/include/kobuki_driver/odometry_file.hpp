// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "kobuki_protocol/odometry.hpp"

namespace tocsin::kobuki {

/// Keeps odometry over a restart of the driver, so that it goes on from where it was and with the
/// motion in between, because the base's encoders and gyro went on. Valid for processes of one
/// parent (the launcher): a new run starts at zero.
class OdometryFile {
 public:
  /// An empty path keeps nothing.
  explicit OdometryFile(std::string path) : path_(std::move(path)) {}
  [[nodiscard]] std::optional<OdometrySnapshot> load() const;
  /// Replaces the file as a whole. False when it cannot be written.
  [[nodiscard]] bool save(const OdometrySnapshot& snapshot) const;

 private:
  std::string path_;
};

}  // namespace tocsin::kobuki
