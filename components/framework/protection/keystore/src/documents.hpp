// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "keystore/permissions.hpp"

namespace tocsin::keystore {

/// How the link is protected (DDS Security 1.1 section 9.4.1.2), for all domains and topics:
/// whoever is not authenticated is not heard; discovery and liveliness are encrypted; of samples
/// the payload is encrypted and the submessage signed. Its header stays readable, as the router
/// takes the DSCP of a packet from its writer.
[[nodiscard]] std::string governance_xml();

/// What one identity may do, and for how long.
struct Grant {
  std::string subject;  ///< RFC 2253
  std::int64_t from_s = 0;
  std::int64_t until_s = 0;
  Permissions permissions;
};
/// Section 9.4.1.3; all that is not allowed is denied.
[[nodiscard]] std::string permissions_xml(const Grant& grant);
/// Nothing when the text is no such document.
[[nodiscard]] std::optional<Grant> grant_in(const std::string& permissions_xml);

/// `2026-11-22T12:00:00Z`.
[[nodiscard]] std::string date_text(std::int64_t time_s);

}  // namespace tocsin::keystore
