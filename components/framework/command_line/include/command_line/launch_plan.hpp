// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "command_line/programs.hpp"
#include "deployment/deployment.hpp"

namespace tocsin {

/// One process that `tocsin launch` starts and keeps.
struct ProcessSpec {
  std::string name;                  ///< "host/process", or "radio"
  std::vector<std::string> command;  ///< the program's path and its arguments
  std::optional<std::size_t> host;   ///< index of its host; none: it runs outside of all hosts
  bool terminal = false;             ///< its stdout is the launcher's
  /// A program of the stack that with `--check` behind its arguments only looks at them and the
  /// files that they name: exit code 0, or one line and 2.
  bool checks_itself = false;
};

/// The file that containers read.
struct ResolvedFile {
  std::string path;
  std::string copy = {};  ///< in memory, for those that are restarted when the file is gone
};

/// The programs and containers of all hosts in starting order. Both `tocsin launch` and `tocsin
/// check` begin here. Throws ConfigError when a program is in none of `folders`.
[[nodiscard]] std::vector<ProcessSpec> plan_processes(const deployment::Deployment& deployment,
                                                      const ResolvedFile& file,
                                                      const Folders& folders);

/// The emulator that joins the two hosts, whose namespaces are open as `descriptors` in the order
/// of the hosts, and that of the second path, where there is one. The deployment must have a radio.
/// Throws like plan_processes.
[[nodiscard]] std::vector<ProcessSpec> plan_radios(const deployment::Deployment& deployment,
                                                   const std::vector<int>& descriptors,
                                                   const Folders& folders);

}  // namespace tocsin
