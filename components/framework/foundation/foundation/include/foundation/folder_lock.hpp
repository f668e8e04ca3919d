// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// Keeps a folder for one process as long as this lives; the kernel gives it back when the process
/// ends, however it ends. Needs no file and no room. Children that execute a program do not keep
/// it.
class FolderLock {
 public:
  /// Throws ConfigError when another process has the folder, EnvironmentError when it cannot be
  /// opened. On a file system that knows no locks nothing is kept.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  FileDescriptor folder_;
};

}  // namespace tocsin
