// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::qos_tool {

/// What the value of a policy means for who writes and reads, as a sentence without units to look
/// up. Empty when the profile has no such policy.
[[nodiscard]] std::string meaning_of(const std::string& policy, const QosProfile& profile);

}  // namespace tocsin::qos_tool
