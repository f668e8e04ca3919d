// SPDX-License-Identifier: Apache-2.0
// A profile as a list of policies with texts, as files, pages and other vendors' files have it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {

/// One policy of a profile.
struct PolicyValue {
  std::string policy;
  std::string value;    ///< as in a QoS file; a list as `[a, b]`
  bool is_default;      ///< it is what a profile has that does not name the policy
  std::string meaning;  ///< of the policy, from the profile's declaration
};

/// In the order of a QoS file's documentation.
[[nodiscard]] std::vector<PolicyValue> values_of(const QosProfile& profile);

/// Values by policy.
using Values = std::map<std::string, std::string>;
[[nodiscard]] Values value_map(const QosProfile& profile);

/// A list of texts in the form of a QoS file, and back.
[[nodiscard]] std::string list_text(const std::vector<std::string>& names);
[[nodiscard]] std::vector<std::string> names_of(const std::string& list);

/// A number of seconds in the form of a QoS file, and back; `.inf` is for ever.
[[nodiscard]] std::string seconds_text(double s);
[[nodiscard]] double seconds_of(const std::string& text);

/// What the runtime makes of a profile: room for samples, mode of publishing and signs of life,
/// where the profile leaves them to it.
[[nodiscard]] QosProfile effective(QosProfile profile);

}  // namespace tocsin::qos_tool
