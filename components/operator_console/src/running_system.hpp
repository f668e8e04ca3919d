// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"

namespace CLI {
class App;
}

namespace tocsin {

/// Which run a command joins, and on which side.
struct JoinOptions {
  std::string run_dir;       ///< empty: the newest of runs/
  std::string host = "gcs";  ///< that the component shall run on: its name, or its role
  /// Adds --run-dir and --host.
  void declare(CLI::App& app);
};

/// One more component for a system that runs.
struct Guest {
  std::string component;
  std::vector<std::string> settings;  ///< "key=value", value in YAML
};

/// The folder of the newest run under `runs`. Throws EnvironmentError when there is none.
[[nodiscard]] std::string newest_run(const std::string& runs);

/// The deployment with one more container on that host, the last one there. Throws ConfigError for
/// a host that is not there and for a setting that is not key=value.
[[nodiscard]] deployment::Deployment with_guest(deployment::Deployment deployment,
                                                const std::string& host, const Guest& guest);

/// Runs the component in a process of its own beside the system that `tocsin launch` runs, with the
/// terminal of this program, until it ends. Returns its exit code.
/// Throws EnvironmentError when nothing runs there, ConfigError as with_guest does.
[[nodiscard]] int run_guest(const JoinOptions& options, const Guest& guest);

}  // namespace tocsin
