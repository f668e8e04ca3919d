// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace tocsin::radio {

/// The access categories of 802.11e, the most urgent first.
enum class AccessCategory : std::uint8_t { voice, video, best_effort, background };

inline constexpr std::array<AccessCategory, 4> access_categories{
    AccessCategory::voice, AccessCategory::video, AccessCategory::best_effort,
    AccessCategory::background};

/// "voice", "video", "best_effort" or "background".
[[nodiscard]] const char* to_string(AccessCategory category);

/// How a queue contends for the medium.
struct AccessRules {
  int aifsn;   ///< [slots] after SIFS that the medium must be idle before its backoff counts
  int cw_min;  ///< [slots] longest backoff of a first attempt
  int cw_max;  ///< [slots] longest backoff of all
};

/// The defaults of 802.11 for OFDM rates (IEEE 802.11-2016, table 9-137). Their TXOP limits are not
/// modelled: each access sends one frame.
[[nodiscard]] constexpr AccessRules access_rules(AccessCategory category) {
  switch (category) {
    case AccessCategory::voice:
      return {2, 3, 7};
    case AccessCategory::video:
      return {2, 7, 15};
    case AccessCategory::best_effort:
      return {3, 15, 1023};
    case AccessCategory::background:
      break;
  }
  return {7, 15, 1023};
}

/// The category of a packet by its DSCP, 0 to 63, the upper six bits of the IP header's TOS byte:
/// as RFC 8325 (section 4) says for the code points that it names, by the upper three bits for all
/// others, both as Linux does. CS6 (48) is voice, CS4 (32) video, 0 best effort, CS1 (8)
/// background.
[[nodiscard]] AccessCategory access_category_of_dscp(std::uint8_t dscp);

}  // namespace tocsin::radio
