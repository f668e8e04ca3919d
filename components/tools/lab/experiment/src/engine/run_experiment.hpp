// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::experiment {

/// Which runs of the file.
enum class Task {
  simulated,  ///< all but those of kind `fit`, in simulated time
  real,       ///< those of kind `real`, on the real stack
  fit,        ///< those of kind `fit`, in simulated time
};

/// What `tocsin experiment run` was asked for.
struct RunOptions {
  std::string file;
  std::string out;    ///< folder of the results
  std::string share;  ///< installed share/tocsin
  int jobs = 1;
  Task task = Task::simulated;
  bool other_build = false;  ///< go on in a folder that another build has begun
};

/// Runs what is not there yet. Returns the exit code: 0, 1 when runs failed, 130 when interrupted.
/// Throws ConfigError and EnvironmentError.
[[nodiscard]] int run_experiment(const RunOptions& options);

/// Runs the sets of kind `fit` and writes the parameters that the file's policies get of them to
/// the file that it names under `fitted`. Exit code and errors as above.
[[nodiscard]] int fit_experiment(const RunOptions& options);

}  // namespace tocsin::experiment
