// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace tocsin {

/// What an operator requests of the control authority: tocsin_msgs/DriverRequest.verb.
enum class ControlVerb {
  ask,   ///< for it, of the driver
  give,  ///< it to who asks, or up
  keep,  ///< it, whoever asks
  take,  ///< it at once, whoever drives; of a supervisor
};
constexpr std::array<const char*, 4> words_of(ControlVerb) {
  return {"ask", "give", "keep", "take"};
}

}  // namespace tocsin
