// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "map_ports/link_risk_input.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "transmission_controller/way_ahead.hpp"

namespace tocsin {

/// Ports of a component that looks ahead on the vehicle's way: `plan`, `location` and `link_risk`.
class ForesightInputs {
 public:
  ForesightInputs(Component& owner, double speed_mps);
  /// Of what has come up to now.
  [[nodiscard]] decision::Outlook outlook(Time now);

 private:
  OptionalInput<topic::Plan> plan_;
  OptionalInput<topic::Location> location_;
  LinkRiskInput risk_;
  WayAhead way_;
};

}  // namespace tocsin
