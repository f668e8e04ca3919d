// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "runtime/middleware/qos_matching.hpp"

namespace tocsin::interop {

/// What a writer offers against what a reader requests.
struct Case {
  std::string policy;  ///< which of them is tried
  QosContract offered;
  QosContract requested;
};

/// Every value of a policy offered against every one requested.
[[nodiscard]] std::vector<Case> all_cases();

/// Whether they match by the table of the DDS specification, as the runtime states it.
[[nodiscard]] inline bool fits(const QosContract& offered, const QosContract& requested) {
  return incompatibilities(offered, requested).empty();
}

/// A line of a QoS file.
[[nodiscard]] std::string profile(const std::string& name, const QosContract& qos);

}  // namespace tocsin::interop
