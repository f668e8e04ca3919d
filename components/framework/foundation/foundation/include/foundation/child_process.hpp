// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "foundation/file_descriptor.hpp"
#include "foundation/privileges.hpp"

namespace tocsin {

/// What a child process starts with.
struct ChildSetup {
  enum class Streams {
    ours,  ///< stdin, stdout and stderr are ours, and so is the process group: Ctrl-C reaches it
    errors_piped,  ///< stdin and stdout are ours, stderr is Child::output; a group of its own
    piped,         ///< nothing to read; stdout and stderr are Child::output; a group of its own
  };
  std::vector<std::string> command;  ///< path and arguments
  Streams streams = Streams::ours;
  int death_signal = SIGTERM;       ///< what the kernel sends it when this process dies
  std::optional<int> network = {};  ///< descriptor of the network namespace to enter
  std::vector<int> inherited = {};  ///< descriptors that stay open in the program
  Capabilities capabilities = {};   ///< of those kept by become_user, what the program gets
};

/// A started process.
struct Child {
  pid_t pid = -1;         ///< with a group of its own also that group's id
  FileDescriptor output;  ///< what it writes to the streams that are piped, non-blocking; else none
};

/// Starts a program that ends when this one dies, with no signal blocked. When it cannot be
/// executed the child says so on its stderr and exits with 127. Throws EnvironmentError when fork
/// fails.
///
/// It forks, where posix_spawn would do without: only the child itself can ask for a signal at its
/// parent's death and enter a namespace, and posix_spawn has no way to tell it to.
[[nodiscard]] Child start_child(const ChildSetup& setup);

/// Blocks until the process has ended. Its exit code; 128 and more for a signal.
[[nodiscard]] int wait_for_child(pid_t pid);

}  // namespace tocsin
