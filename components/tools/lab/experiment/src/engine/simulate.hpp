// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "plan/plan.hpp"
#include "results/run_result.hpp"

namespace tocsin::experiment {

/// Where programs and files are found.
struct Places {
  std::string share;   ///< installed share/tocsin
  std::string folder;  ///< of the experiment's results
};

/// Runs the components in virtual time on this thread. A component that throws, or a bringup that
/// is wrong, is a failure of the result.
[[nodiscard]] RunResult simulate(const Run& run, const Timing& timing, const Places& places);

}  // namespace tocsin::experiment
