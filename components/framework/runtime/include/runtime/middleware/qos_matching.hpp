// SPDX-License-Identifier: Apache-2.0
// Which writers and readers match: the table of the DDS specification.
#pragma once

#include <string>
#include <vector>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// One policy of the table: what a writer must offer for what a reader requests.
struct MatchingRule {
  const char* policy;
  const char* rule;  ///< in words
  bool (*met)(const QosContract& offered, const QosContract& requested);
  std::string (*value)(const QosContract& contract);  ///< as a person reads it
  /// The same as Fast DDS 2.9.1 decides it; null: it does not look at this policy.
  bool (*met_for_fast_dds)(const QosContract& offered, const QosContract& requested);
};

/// Offered against requested (formal/15-04-10, section 2.2.3; data representation: DDS-XTypes 1.3,
/// section 7.6.3.1), and partitions, which the specification does not count among these but which
/// keep ends apart as well.
[[nodiscard]] const std::vector<MatchingRule>& matching_rules();

/// Names of the policies of that table by which a reader that requests `requested` will not match a
/// writer that offers `offered`. Empty when they match.
[[nodiscard]] std::vector<std::string> incompatibilities(const QosContract& offered,
                                                         const QosContract& requested);

/// The same as two ends of Fast DDS 2.9.1 decide it, which departs from the specification.
[[nodiscard]] std::vector<std::string> incompatibilities_for_fast_dds(const QosContract& offered,
                                                                      const QosContract& requested);

/// A duration as a person reads it: `0.2 s`, `for ever`.
[[nodiscard]] std::string duration_text(double s);

}  // namespace tocsin
