// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/role.hpp"
#include "keystore/permissions.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {

/// On which routers tell each other what came.
inline constexpr const char* link_acknowledgement_topic = "link_acknowledgement";
/// On which they send each other what did not cross at first.
inline constexpr const char* backfill_topic = "link_backfill";
/// On which they tell each other what services their hosts have and want.
inline constexpr const char* link_services_topic = "link_services";
/// On which calls of a class cross, and those that end with an action.
[[nodiscard]] std::string link_calls_topic(const CallClass& calls);
[[nodiscard]] std::string link_results_topic(const CallClass& calls);

/// Whether a topic is one of those, of which no rule tells: of calls if the file has some.
[[nodiscard]] bool is_of_routers(const TrafficRules& rules, const std::string& topic);

/// What a flow of such a topic, or of another, is for.
[[nodiscard]] LinkPurpose purpose_of(const std::string& topic);

/// Whose permissions on a secured link are meant.
struct LinkSide {
  Role role = Role::uxv;
  std::string traffic_file;  ///< which topics cross the link, from which side
};

/// What a router of this side needs: it publishes what its role sends, hears what the other sends,
/// acknowledgements, backfills and calls go both ways. Throws ConfigError for the traffic file.
[[nodiscard]] keystore::Permissions link_permissions(const LinkSide& side);

}  // namespace tocsin
