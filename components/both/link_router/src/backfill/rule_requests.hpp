// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "link_router/history_requests.hpp"

namespace tocsin {

/// What is kept of the requests of rules for the next instance of a router: a line for each.
[[nodiscard]] std::string to_text(const std::vector<router::RuleRequest>& requests);
/// Lines that are none are left out.
[[nodiscard]] std::vector<router::RuleRequest> rule_requests_in(const std::string& text);

}  // namespace tocsin
