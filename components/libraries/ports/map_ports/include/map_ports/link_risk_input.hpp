// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "navigation/link_risk.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that heeds where the link is lost: its port `link_risk`. What is no grid
/// is passed over with a warning. Used by the component's thread.
class LinkRiskInput {
 public:
  explicit LinkRiskInput(Component& owner);
  /// The newest that has come since the last call.
  [[nodiscard]] std::optional<navigation::LinkRisk> take();

 private:
  OptionalInput<topic::LinkRisk> risk_;
  Logger log_;
};

}  // namespace tocsin
