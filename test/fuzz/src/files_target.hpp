// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::fuzz {

/// A kind of file that users write: one that is shipped, and what reads it.
struct FileKind {
  std::string name;  ///< below the folder that has bringup/ and config/
  /// Reads the file at `path`. Throws ConfigError, and nothing else, when it is wrong.
  void (*load)(const std::string& path);
};

/// All kinds.
[[nodiscard]] const std::vector<FileKind>& file_kinds();

}  // namespace tocsin::fuzz
