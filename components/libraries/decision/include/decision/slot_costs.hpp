// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::decision {

/// What one slot costs, in units of a low-priority message lost in a bad network.
struct SlotCosts {
  double send_bad = 1;       ///< speaking while the network is bad
  double silent_good = 0.5;  ///< silent while it is good
  double silent_bad = 0.1;   ///< silent while it is bad
  double change = 0.5;       ///< each change between speaking and silence
};

}  // namespace tocsin::decision
