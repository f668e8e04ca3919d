// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::interop {

/// What a writer offers against what a reader requests.
struct Case {
  std::string policy;  ///< which of them is tried
  QosContract offered;
  QosContract requested;
};

/// Every value of a policy offered against every one requested.
[[nodiscard]] std::vector<Case> all_cases();

/// Whether they match by the table of the DDS specification (formal/15-04-10, section 2.2.3).
[[nodiscard]] bool fits(const QosContract& offered, const QosContract& requested);

/// A line of a QoS file.
[[nodiscard]] std::string profile(const std::string& name, const QosContract& qos);

}  // namespace tocsin::interop
