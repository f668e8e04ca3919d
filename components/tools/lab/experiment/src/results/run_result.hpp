// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "metrics/metrics.hpp"

namespace tocsin::experiment {

/// What a run left behind.
struct RunResult {
  std::string failure;     ///< one line; empty: the run is good
  double simulated_s = 0;  ///< or driven, in reality
  Measures measures;
};

}  // namespace tocsin::experiment
