// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tocsin::bench {

/// The value below which `share` of them lie; 0 of none. Sorts them.
[[nodiscard]] double quantile(std::vector<double>& values, double share);

/// Mean, and half of its 95 % interval (normal approximation).
struct Mean {
  double mean = 0;
  double half = 0;
};
[[nodiscard]] Mean mean_of(const std::vector<double>& values);

}  // namespace tocsin::bench
