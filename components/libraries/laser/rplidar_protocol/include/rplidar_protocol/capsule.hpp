// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "rplidar_protocol/answer.hpp"

namespace tocsin::rplidar {

/// 32 readings of an express scan. Their angles lie evenly between the start of this capsule and
/// that of the next one, each with a correction of its own.
struct Capsule {
  double start_rad = 0;  ///< clockwise [range 0,2 pi)
  bool begins = false;   ///< the first one of a scan
  std::array<double, capsule_readings> ranges_m{};
  std::array<double, capsule_readings> corrections_rad{};  ///< to be subtracted
};

/// Whether 84 bytes have the two sync nibbles and a good checksum.
[[nodiscard]] bool is_capsule(ByteView bytes);
[[nodiscard]] Capsule decode_capsule(ByteView bytes);
/// The readings of `capsule`, known once the start of the next one is.
[[nodiscard]] std::array<Reading, capsule_readings> readings_of(const Capsule& capsule,
                                                                double next_start_rad);

}  // namespace tocsin::rplidar
