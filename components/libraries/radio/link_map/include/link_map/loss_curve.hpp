// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "link_map/link_map.hpp"

namespace tocsin::link_map {

/// The share of packets that is lost at a signal: 1 / (1 + exp((signal - half) / width)), as the
/// error of a radio's frames falls with its signal.
struct LossCurve {
  double half_dbm = -82;  ///< where half of the packets are lost
  double width_db = 2.5;

  [[nodiscard]] double lost_share(double signal_dbm) const;
};

/// The likeliest curve of readings that tell loss, held near usual values of a card (half at -82
/// +- 8 dBm, 2.5 dB wide within a factor of 1.6), which are the answer to none. Loss at a good
/// signal is another's doing, as of a queue that overflows: one in ten readings may be such.
[[nodiscard]] LossCurve fit_loss_curve(const std::vector<Reading>& readings);

/// The chance that half of the packets or more are lost where this is foretold [range 0,1].
[[nodiscard]] double risk(const LossCurve& curve, const Prediction& prediction);

}  // namespace tocsin::link_map
