// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace tocsin::decision {

/// What one slot costs, in units of a low-priority message lost in a bad network.
struct SlotCosts {
  double send_bad = 1;       ///< speaking while the network is bad
  double silent_good = 0.5;  ///< silent while it is good
  double silent_bad = 0.1;   ///< silent while it is bad
  double change = 0.5;       ///< each change between speaking and silence
};

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

}  // namespace tocsin::decision
