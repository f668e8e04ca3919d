// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "map_ports/link_risk_input.hpp"
#include "navigator/navigator.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Ports of a component whose navigator heeds where the link is lost: `link_risk` in, `plan/choice`
/// out.
class LinkPorts {
 public:
  explicit LinkPorts(Component& owner);

  void take(Navigator& navigator);
  /// Tells how a new plan was chosen, with the time of the report.
  void report(const Navigator& navigator, double speed_mps,
              const builtin_interfaces::msg::Time& stamp);

 private:
  LinkRiskInput risk_;
  Output<topic::PlanChoice> choice_;
  Logger log_;
  std::uint64_t plans_ = 0;  // that were told of
};

}  // namespace tocsin
