// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin::qos_tool {

struct TuneOptions {
  std::string file;         ///< path, or the bare name of a shipped one
  std::string out;          ///< folder of the results; empty: tuning/NAME
  std::optional<int> jobs;  ///< simulated runs at a time; empty: all cores
};

/// Plays the candidates of a tune file in simulation by `tocsin experiment`, ranks them, and plays
/// the best and the shipped ones on the real stack when the file says so. Called again it goes on.
/// Returns the exit code. Throws ConfigError and EnvironmentError.
int run_tune(const TuneOptions& options);

}  // namespace tocsin::qos_tool
