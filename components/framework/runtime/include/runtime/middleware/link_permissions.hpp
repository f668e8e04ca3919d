// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/role.hpp"
#include "keystore/permissions.hpp"

namespace tocsin {

/// On which routers tell each other what came.
inline constexpr const char* link_receipt_topic = "link_receipt";
/// On which they send each other what did not cross at first.
inline constexpr const char* fill_in_topic = "link_fill_in";

/// Whose permissions on a secured link are meant.
struct LinkSide {
  Role role = Role::uxv;
  std::string traffic_file;   ///< which topics cross the link, from which side
  std::string ros_namespace;  ///< of all topics; empty for none
};

/// What a router of this side needs: it publishes what its role sends, hears what the other sends,
/// receipts and fill-ins go both ways. Throws ConfigError for the traffic file.
[[nodiscard]] keystore::Permissions link_permissions(const LinkSide& side);

}  // namespace tocsin
