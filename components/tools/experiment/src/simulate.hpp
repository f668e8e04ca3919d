// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiment/metrics.hpp"
#include "experiment/plan.hpp"

namespace tocsin::experiment {

/// What a run left behind.
struct RunResult {
  std::string failure;     ///< one line; empty: the run is good
  double simulated_s = 0;  ///< or driven, in reality
  Measures measures;
};

/// Where programs and files are found.
struct Places {
  std::string share;   ///< installed share/tocsin
  std::string folder;  ///< of the experiment's results
};

/// Runs the components in virtual time on this thread. A component that throws, or a bringup that
/// is wrong, is a failure of the result.
[[nodiscard]] RunResult simulate(const Run& run, const Timing& timing, const Places& places);

}  // namespace tocsin::experiment
