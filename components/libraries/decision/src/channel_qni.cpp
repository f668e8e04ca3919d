// SPDX-License-Identifier: Apache-2.0
#include "decision/channel_qni.hpp"

#include "weighted_terms.hpp"

namespace tocsin::decision {
namespace {

bool known(const std::optional<double>& x) { return x && !std::isnan(*x); }

std::optional<double> worse(const std::optional<double>& a, const std::optional<double>& b) {
  if (!known(a)) return b;
  if (!known(b)) return a;
  return std::min(*a, *b);
}

}  // namespace

ChannelQniModel::ChannelQniModel(const ChannelQniParams& params) : params_(params) {
  check_qni(params.weight_per + params.weight_signal + params.weight_channel,
            params.signal_worst_dbm, params.signal_best_dbm);
}

Qni ChannelQniModel::evaluate(const ChannelQniInput& input) const {
  const ChannelQniParams& p = params_;
  WeightedTerms terms;
  Qni qni{};
  qni.has_per = terms.add(p.weight_per, on_scale(input.per_percent, 100, 0));
  qni.has_signal =
      terms.add(p.weight_signal, on_scale(input.signal_dbm, p.signal_worst_dbm, p.signal_best_dbm));
  const auto idle = on_scale(input.busy_share, 1, 0);
  const auto smooth = on_scale(input.retries_per_frame, p.retries_worst, 0);
  qni.has_quality = terms.add(p.weight_channel, worse(idle, smooth));
  qni.value = terms.value();
  qni.weight_share = terms.share();
  return qni;
}

}  // namespace tocsin::decision
