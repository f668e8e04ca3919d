// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/bytes.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

/// Gains as command 13 and feedback 21 carry them; zeros where the bytes end.
[[nodiscard]] inline ControllerGains read_gains(ByteReader in) {
  ControllerGains gains;
  gains.type = in.u8();
  gains.kp_milli = in.u32();
  gains.ki_milli = in.u32();
  gains.kd_milli = in.u32();
  return gains;
}

}  // namespace tocsin::kobuki
