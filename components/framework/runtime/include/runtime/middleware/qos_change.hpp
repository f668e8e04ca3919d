// SPDX-License-Identifier: Apache-2.0
// What of a topic's QoS may be changed while its writers and readers exist.
#pragma once

#include <string>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// A request to change policies of the ends of a topic in one process; with neither writers nor
/// readers it is only checked.
struct QosChange {
  std::string topic;     ///< as components name it, without namespace
  bool writers = true;   ///< changes what is offered
  bool readers = true;   ///< changes what is requested
  std::string settings;  ///< a YAML map: policies of a profile and their values
};

/// Why a policy of a profile cannot change while its ends exist; empty: it can, or it is no policy.
[[nodiscard]] std::string why_fixed(const std::string& policy);

/// The policies that can change, in the order of a profile.
[[nodiscard]] std::vector<std::string> changeable_policies();

/// Throws ConfigError for what no profile's change could be: no policy, one that cannot change, or
/// a value out of range.
void check_change(const std::string& settings);

/// `profile` with the settings of a YAML map. Throws ConfigError for what is no policy, cannot
/// change, is out of range, or contradicts the rest of the profile.
[[nodiscard]] QosProfile changed(const QosProfile& profile, const std::string& settings);

}  // namespace tocsin
