// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "decision/policy.hpp"
#include "decision/slot_costs.hpp"

namespace tocsin::decision {

/// The cost of both actions in one slot of a known trace.
struct Slot {
  double send;
  double silent;
};

/// The slots of a trace whose states are known (true is bad).
[[nodiscard]] std::vector<Slot> slots_of(const std::vector<bool>& bad, const SlotCosts& costs);

/// The least cost that any choice of actions could have had, and that choice.
struct Clairvoyant {
  double cost;
  std::vector<bool> send;  ///< per slot; true is speaking
};

/// Dynamic programme over the age of silence on a known trace: begins speaking, is never silent
/// for more than `th_max_samples` slots in a row, pays `change` per change. Offline only.
[[nodiscard]] Clairvoyant clairvoyant(const std::vector<Slot>& slots, double change,
                                      int th_max_samples);

/// What a sequence of actions costs on the same slots; begins speaking.
[[nodiscard]] double cost_of(const std::vector<Slot>& slots, double change,
                             const std::vector<bool>& send);

/// The clairvoyant for a known trace, offline only: slot n is the one in which sample n is taken,
/// so that sample n decides slot n + 1 as for any policy; the first slot is spoken in. Never silent
/// beyond th_max_samples; without th_max_s.
[[nodiscard]] std::unique_ptr<Policy> make_oracle(const std::vector<Slot>& slots, double change,
                                                  int th_max_samples);

}  // namespace tocsin::decision
