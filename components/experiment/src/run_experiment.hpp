// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::experiment {

/// What `tocsin experiment run` was asked for.
struct RunOptions {
  std::string file;
  std::string out;    ///< folder of the results
  std::string share;  ///< installed share/tocsin
  int jobs = 1;
  bool real = false;  ///< the runs of kind `real`, on the real stack
};

/// Runs what is not there yet. Returns the exit code: 0, 1 when runs failed, 130 when interrupted.
/// Throws ConfigError and EnvironmentError.
[[nodiscard]] int run_experiment(const RunOptions& options);

}  // namespace tocsin::experiment
