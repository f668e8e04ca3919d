// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/numbers.hpp"

/// Dimensions of the base (reference page 1.6).
namespace tocsin::kobuki {

inline constexpr double wheel_separation_m = 0.230;
inline constexpr double wheel_radius_m = 0.035;
inline constexpr double body_radius_m = 0.178;
inline constexpr double max_speed_mps = 0.70;
inline constexpr double max_turn_rate_rad_s = 180.0 * degree;

/// 52 ticks per motor turn and gear 6545/132 make 2578.33 per wheel turn; this is the figure of the
/// reference driver, which is 2e-7 smaller.
inline constexpr double tick_rad = 0.002436916871363930;
inline constexpr double tick_m = tick_rad * wheel_radius_m;

inline constexpr double gyro_digit_rad_s = 0.00875 * degree;
inline constexpr double centidegree_rad = 0.01 * degree;

}  // namespace tocsin::kobuki
