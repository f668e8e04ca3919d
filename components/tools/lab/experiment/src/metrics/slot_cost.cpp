// SPDX-License-Identifier: Apache-2.0
#include "metrics/slot_cost.hpp"

#include <cmath>

#include "decision/design/costs.hpp"

namespace tocsin::experiment {

std::vector<bool> bad_slots(const std::vector<Observation>& series) {
  std::vector<bool> bad;
  for (const Observation& one : series) bad.push_back(one.poor > 0.5);
  return bad;
}

SlotCost slot_cost(const std::vector<Observation>& series) {
  if (series.empty()) return {std::nan(""), std::nan("")};
  const decision::SlotCosts costs;
  const auto slots = decision::slots_of(bad_slots(series), costs);
  std::vector<bool> sent;
  for (const Observation& one : series) sent.push_back(one.active >= 0.5);
  const double scale = 1000.0 / static_cast<double>(series.size());
  return {scale * decision::cost_of(slots, costs.change, sent),
          scale * decision::clairvoyant(slots, costs.change, clairvoyant_th_max).cost};
}

}  // namespace tocsin::experiment
