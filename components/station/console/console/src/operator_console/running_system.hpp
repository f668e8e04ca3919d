// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "deployment/running_host.hpp"

namespace CLI {
class App;
}

namespace tocsin {

/// Which run a command joins, and on which side.
struct JoinOptions {
  std::string run_dir;       ///< empty: the one that runs on this computer
  std::string host = "gcs";  ///< that the component shall run on: its name, or its role
  std::string vehicle = {};  ///< of several that the station serves; empty: none is named
  /// Adds --run-dir, --host and --vehicle. `without`: which run is meant without --run-dir.
  void declare(CLI::App& app, const std::string& without = "the one that runs");
};

/// One more component for a system that runs.
struct Guest {
  std::string component;
  std::vector<std::string> settings;  ///< "key=value", value in YAML
};

/// Whom the host serves of several vehicles: the one that the options name, else all. One empty
/// name for a host that serves none by name. Throws ConfigError for a vehicle that is not there.
[[nodiscard]] std::vector<std::string> vehicles_of(const JoinOptions& options,
                                                   const deployment::Deployment& deployment,
                                                   const std::string& host);

/// The running hosts of that name or role, all or those of one run.
[[nodiscard]] std::vector<deployment::RunningHost> hosts_to_join(const JoinOptions& options,
                                                                 deployment::RunningHosts running);
/// The only one of them. Throws EnvironmentError when there is none, ConfigError that names the
/// runs when there are several.
[[nodiscard]] deployment::RunningHost host_to_join(const JoinOptions& options,
                                                   deployment::RunningHosts running);

/// The deployment with one more container on the host of that name, the last one there; it serves
/// that vehicle.
/// Throws ConfigError for a setting that is not key=value.
[[nodiscard]] deployment::Deployment with_guest(deployment::Deployment deployment,
                                                const std::string& host, const Guest& guest,
                                                const std::string& vehicle = "");

/// Runs the component in a process of its own beside the system that `tocsin launch` runs, with the
/// terminal of this program, until it ends. Returns its exit code. Writes no file.
/// Throws EnvironmentError when nothing runs there, ConfigError as with_guest does.
[[nodiscard]] int run_guest(const JoinOptions& options, const Guest& guest);

}  // namespace tocsin
