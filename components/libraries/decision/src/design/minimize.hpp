// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace tocsin::decision {

/// Where a minimisation ended.
struct Minimum {
  std::vector<double> x;
  double value;
  bool converged;  ///< false when the evaluations ran out before the simplex had shrunk
};

/// Minimises `f` from `start` by the simplex of Nelder and Mead (1965) as NLopt has it, restarted
/// once at its end so that a collapsed simplex does not pass for a minimum. `f` may return infinity
/// for "outside", but not at `start`. Blocks for at most 12,000 evaluations.
[[nodiscard]] Minimum minimize(const std::function<double(const std::vector<double>&)>& f,
                               const std::vector<double>& start);

}  // namespace tocsin::decision
