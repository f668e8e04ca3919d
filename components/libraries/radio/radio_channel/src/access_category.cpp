// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/access_category.hpp"

namespace tocsin::radio {
namespace {

/// 802.1D user priority, 0 to 7, of a DSCP.
int user_priority(std::uint8_t dscp) {
  switch (dscp) {
    case 10:  // AF11 to AF13
    case 12:
    case 14:
    case 16:  // CS2
      return 0;
    case 18:  // AF21 to AF23
    case 20:
    case 22:
      return 3;
    case 24:  // CS3
    case 26:  // AF31 to AF33
    case 28:
    case 30:
      return 4;
    case 44:  // voice admit
    case 46:  // EF
      return 6;
    default:
      return dscp >> 3;
  }
}

}  // namespace

const char* to_string(AccessCategory category) {
  switch (category) {
    case AccessCategory::voice:
      return "voice";
    case AccessCategory::video:
      return "video";
    case AccessCategory::best_effort:
      return "best_effort";
    case AccessCategory::background:
      return "background";
  }
  return "unknown";
}

/// IEEE 802.11-2016, table 10-1.
AccessCategory access_category_of_dscp(std::uint8_t dscp) {
  switch (user_priority(dscp)) {
    case 1:
    case 2:
      return AccessCategory::background;
    case 4:
    case 5:
      return AccessCategory::video;
    case 6:
    case 7:
      return AccessCategory::voice;
    default:
      return AccessCategory::best_effort;
  }
}

}  // namespace tocsin::radio
