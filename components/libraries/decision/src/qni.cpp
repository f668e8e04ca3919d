// SPDX-License-Identifier: Apache-2.0
#include "decision/qni.hpp"

#include <cmath>
#include <sstream>

#include "foundation/error.hpp"
#include "weighted_terms.hpp"

namespace tocsin::decision {

void check_qni(double weight_sum, double worst_dbm, double best_dbm) {
  std::ostringstream text;
  if (!(std::abs(weight_sum - 1) <= 1e-6)) {
    text << "qni: the weights sum to " << weight_sum << ", must be 1";
  } else if (!(worst_dbm < best_dbm)) {
    text << "qni.signal_worst_dbm: " << worst_dbm << " must be below signal_best_dbm, " << best_dbm;
  }
  if (!text.str().empty()) throw ConfigError(text.str());
}

QniModel::QniModel(const QniParams& params) : params_(params) {
  check_qni(params.weight_per + params.weight_signal + params.weight_quality,
            params.signal_worst_dbm, params.signal_best_dbm);
}

Qni QniModel::evaluate(const QniInput& input) const {
  const QniParams& p = params_;
  WeightedTerms terms;
  Qni qni{};
  qni.has_per = terms.add(p.weight_per, on_scale(input.per_percent, 100, 0));
  qni.has_signal =
      terms.add(p.weight_signal, on_scale(input.signal_dbm, p.signal_worst_dbm, p.signal_best_dbm));
  qni.has_quality = terms.add(p.weight_quality, on_scale(input.quality, 0, p.quality_best));
  qni.value = terms.value();
  qni.weight_share = terms.share();
  return qni;
}

}  // namespace tocsin::decision
