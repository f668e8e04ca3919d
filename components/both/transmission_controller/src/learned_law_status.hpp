// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "decision/site_learner.hpp"
#include "ros_idl/diagnostic_msgs.hpp"

namespace tocsin {

/// The status "OWNER: laws" of `diagnostics`: OK, with all numbers of the evidence.
[[nodiscard]] diagnostic_msgs::msg::DiagnosticStatus status_of(const decision::LearnedLaw& law,
                                                               const std::string& owner);

}  // namespace tocsin
