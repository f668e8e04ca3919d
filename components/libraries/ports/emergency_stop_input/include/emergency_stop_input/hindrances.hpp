// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin {

/// What keeps the vehicle from moving as its drivers want, in words, the gravest first; empty:
/// nothing. The names of who stopped it are as the vehicle reports them, perhaps not printable.
[[nodiscard]] std::vector<std::string> hindrances(const tocsin_msgs::msg::SafetyStatus& status);

}  // namespace tocsin
