// SPDX-License-Identifier: Apache-2.0
#include "rtps_filter/drop_reason.hpp"

#include <array>

namespace tocsin::rtps_filter {

std::string_view to_text(DropReason reason) {
  static constexpr std::array<std::string_view, drop_reasons> names{"not_rtps",
                                                                    "submessage_length",
                                                                    "vendor_submessage",
                                                                    "inline_qos_offset",
                                                                    "parameter_length",
                                                                    "parameter_content",
                                                                    "security_content",
                                                                    "sequence_number",
                                                                    "gap_range",
                                                                    "sequence_jump",
                                                                    "fragment",
                                                                    "sample_size",
                                                                    "payload",
                                                                    "discovery_payload",
                                                                    "foreign_identity",
                                                                    "forged_source",
                                                                    "forged_disposal",
                                                                    "unknown_source",
                                                                    "other_user",
                                                                    "closed_socket",
                                                                    "too_many_participants",
                                                                    "too_many_endpoints",
                                                                    "too_many_announcements",
                                                                    "too_many_bytes",
                                                                    "unsealed",
                                                                    "unauthenticated"};
  return names[static_cast<std::size_t>(reason)];
}

}  // namespace tocsin::rtps_filter
