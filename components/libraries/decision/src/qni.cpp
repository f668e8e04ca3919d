// SPDX-License-Identifier: Apache-2.0
#include "decision/qni.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

/// Weighted mean of the terms that are present; each in [0,100].
class WeightedTerms {
 public:
  /// Takes part when `x` is present and not NaN, with 0 at `worst` and 100 at `best`, clipped.
  /// Returns whether it did.
  bool add(double weight, std::optional<double> x, double worst, double best) {
    if (!x || std::isnan(*x)) return false;
    sum_ += weight * std::clamp((*x - worst) / (best - worst) * 100.0, 0.0, 100.0);
    share_ += weight;
    return true;
  }
  /// NaN when no term of positive weight took part.
  [[nodiscard]] double value() const { return share_ <= 0 ? nan : std::min(sum_ / share_, 100.0); }
  [[nodiscard]] double share() const { return share_; }

 private:
  double sum_ = 0;
  double share_ = 0;
};

}  // namespace

QniModel::QniModel(const QniParams& params) : params_(params) {
  const double sum = params.weight_per + params.weight_signal + params.weight_quality;
  std::ostringstream text;
  if (!(std::abs(sum - 1) <= 1e-6)) {
    text << "qni: the weights sum to " << sum << ", must be 1";
  } else if (!(params.signal_worst_dbm < params.signal_best_dbm)) {
    text << "qni.signal_worst_dbm: " << params.signal_worst_dbm
         << " must be below signal_best_dbm, " << params.signal_best_dbm;
  }
  if (!text.str().empty()) throw ConfigError(text.str());
}

Qni QniModel::evaluate(const QniInput& input) const {
  const QniParams& p = params_;
  WeightedTerms terms;
  Qni qni{};
  qni.has_per = terms.add(p.weight_per, input.per_percent, 100, 0);
  qni.has_signal =
      terms.add(p.weight_signal, input.signal_dbm, p.signal_worst_dbm, p.signal_best_dbm);
  qni.has_quality = terms.add(p.weight_quality, input.quality, 0, p.quality_best);
  qni.value = terms.value();
  qni.weight_share = terms.share();
  return qni;
}

}  // namespace tocsin::decision
