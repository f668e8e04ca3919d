// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "navigator/navigator.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Ports of a component whose navigator heeds where the link is lost: `link_risk` in, `plan/choice`
/// out. What is no grid is passed over with a warning.
class LinkPorts {
 public:
  explicit LinkPorts(Component& owner);

  void take(Navigator& navigator);
  /// Tells how a new plan was chosen, with the time of the report.
  void report(const Navigator& navigator, double speed_mps,
              const builtin_interfaces::msg::Time& stamp);

 private:
  OptionalInput<topic::LinkRisk> risk_;
  Output<topic::PlanChoice> choice_;
  Logger log_;
  std::uint64_t plans_ = 0;  // that were told of
};

}  // namespace tocsin
