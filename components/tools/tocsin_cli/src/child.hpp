// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin::cli {

/// What a child process starts with.
struct ChildSetup {
  std::vector<std::string> command;  ///< path and arguments
  std::optional<int> network;        ///< descriptor of the network namespace to enter
  std::vector<int> inherited;        ///< descriptors that stay open in the program
  bool terminal = false;             ///< stdin and stdout stay the launcher's
};

/// A started process.
struct Child {
  pid_t pid = -1;         ///< also the id of its process group
  FileDescriptor output;  ///< its stdout and stderr (only stderr with `terminal`), non-blocking
};

/// Starts a process that the kernel kills when this one dies. When the program cannot be executed
/// the child says so on its output and exits with 127. Throws EnvironmentError when fork fails.
[[nodiscard]] Child start_child(const ChildSetup& setup);

}  // namespace tocsin::cli
