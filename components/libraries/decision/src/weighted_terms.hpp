// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tocsin::decision {

/// Weighted mean of the terms that are present; each in [0,100].
class WeightedTerms {
 public:
  /// Takes part when `score` is present and not NaN; clipped to [0,100]. Returns whether it did.
  bool add(double weight, std::optional<double> score) {
    if (!score || std::isnan(*score)) return false;
    sum_ += weight * std::clamp(*score, 0.0, 100.0);
    share_ += weight;
    return true;
  }
  /// NaN when no term of positive weight took part.
  [[nodiscard]] double value() const {
    if (share_ <= 0) return std::numeric_limits<double>::quiet_NaN();
    return std::min(sum_ / share_, 100.0);
  }
  [[nodiscard]] double share() const { return share_; }

 private:
  double sum_ = 0;
  double share_ = 0;
};

/// Throws ConfigError unless the weights sum to 1 and worst is below best.
void check_qni(double weight_sum, double worst_dbm, double best_dbm);

/// 0 at `worst`, 100 at `best`, straight between and beyond; absent stays absent.
inline std::optional<double> on_scale(std::optional<double> x, double worst, double best) {
  if (!x) return std::nullopt;
  return (*x - worst) / (best - worst) * 100.0;
}

}  // namespace tocsin::decision
