// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "metrics/metrics.hpp"

namespace tocsin::experiment {

/// The longest silence that the clairvoyant allows himself, as PolicyParams of the library do.
inline constexpr int clairvoyant_th_max = 30;

/// What the slots of a run cost by the decision library's SlotCosts, per 1000 slots. A slot is an
/// observation; it is bad when the link was truly poor for more than half of it, spoken in when
/// the gate was open for at least half of it. NaN without observations.
struct SlotCost {
  double own;
  double clairvoyant;  ///< the least that was possible
};
[[nodiscard]] SlotCost slot_cost(const std::vector<Observation>& series);

/// Which observations are bad slots.
[[nodiscard]] std::vector<bool> bad_slots(const std::vector<Observation>& series);

}  // namespace tocsin::experiment
