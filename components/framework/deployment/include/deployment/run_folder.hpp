// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "foundation/folder_lock.hpp"

namespace tocsin::deployment {

/// The folder of one run. It belongs to that run alone: it was new or empty, and nobody else gets
/// it as long as this lives.
class RunFolder {
 public:
  /// Makes it and its parents. An empty `wanted` means a new folder named by the time, `unnamed` +
  /// "<UTC time>", with "_2", "_3", ... when others begin in the same second. Throws ConfigError
  /// when it is in use, holds anything, or others may write to it, EnvironmentError when it cannot
  /// be made.
  explicit RunFolder(const std::string& wanted, const std::string& unnamed = "runs/");

  /// Absolute.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::optional<FolderLock> lock_;
};

}  // namespace tocsin::deployment
