// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "kobuki_protocol/frame.hpp"
#include "kobuki_protocol/version.hpp"

namespace tocsin::kobuki {

/// What the base sends. Numbers are the raw ones of the wire (reference page 1.3); masks keep bits
/// that nobody documented.

inline constexpr std::uint8_t right_bit = 0x01;   ///< bumper, cliff, wheel drop
inline constexpr std::uint8_t centre_bit = 0x02;  ///< bumper, cliff
inline constexpr std::uint8_t left_bit = 0x04;    ///< bumper, cliff
inline constexpr std::uint8_t left_wheel_drop_bit = 0x02;
inline constexpr std::uint8_t left_over_current_bit = 0x01;
inline constexpr std::uint8_t right_over_current_bit = 0x02;

/// ID 1, in every frame.
struct CoreSensors {
  std::uint16_t timestamp_ms = 0;  ///< since power-on, wraps
  std::uint8_t bumper = 0;
  std::uint8_t wheel_drop = 0;
  std::uint8_t cliff = 0;
  std::uint16_t left_encoder = 0;  ///< ticks, forward increases, wraps, starts anywhere
  std::uint16_t right_encoder = 0;
  std::int8_t left_pwm = 0;  ///< percent, -100 to 100
  std::int8_t right_pwm = 0;
  std::uint8_t buttons = 0;     ///< bits 0 to 2
  std::uint8_t charger = 0;     ///< low nibble 0 discharging, 2 charged, 6 charging; 0x10 adapter
  std::uint8_t battery_dv = 0;  ///< 0.1 V
  std::uint8_t over_current = 0;
};

/// ID 3. What each receiver sees of a dock: beams, of its near and its far field.
struct DockInfrared {
  enum Signal : std::uint8_t {
    near_left = 1,
    near_centre = 2,
    near_right = 4,
    far_centre = 8,
    far_left = 16,
    far_right = 32
  };
  static constexpr unsigned any_near = near_left | near_centre | near_right;
  static constexpr unsigned any_far = far_left | far_centre | far_right;
  static constexpr unsigned any_left = near_left | far_left;
  static constexpr unsigned any_centre = near_centre | far_centre;
  static constexpr unsigned any_right = near_right | far_right;
  std::uint8_t right = 0;
  std::uint8_t centre = 0;
  std::uint8_t left = 0;
};

/// ID 4, the factory-calibrated heading.
struct Inertia {
  std::int16_t angle_cdeg = 0;       ///< 0.01 deg, counter-clockwise positive
  std::int16_t angle_rate_cdps = 0;  ///< 0.01 deg/s
};

/// ID 5, 0 to 4095 for 0 to 3.3 V; about 1600 to 2050 on floor.
struct CliffAdc {
  std::uint16_t right = 0;
  std::uint16_t centre = 0;
  std::uint16_t left = 0;
};

/// ID 6, 10 mA units.
struct MotorCurrent {
  std::uint8_t left = 0;
  std::uint8_t right = 0;
};

/// ID 13, 0.00875 deg/s per digit in the axes of the chip, 100 Hz.
struct RawGyro {
  struct Sample {
    std::int16_t x = 0;
    std::int16_t y = 0;
    std::int16_t z = 0;
  };
  /// Real bases send 2 or 3 samples. A frame that claims more than this is malformed; the reference
  /// driver overruns its array there (reference page 3.4).
  static constexpr std::size_t max_samples = 8;

  std::uint8_t frame_id = 0;  ///< of the first sample
  std::uint8_t count = 0;     ///< valid entries of `samples`
  std::array<Sample, max_samples> samples{};
};

/// ID 15; declared by the vendor, never used.
struct EepromData {
  std::uint8_t frame_id = 0;
  std::array<std::uint8_t, 16> bytes{};
};

/// ID 16.
struct GeneralInput {
  std::uint16_t digital = 0;              ///< bits 0 to 3, high is set; 0x40 test board
  std::array<std::uint16_t, 4> analog{};  ///< 0 to 4095 for 0 to 3.3 V
  std::array<std::uint16_t, 3> unused{};
};

/// ID 19.
using UniqueId = std::array<std::uint32_t, 3>;

/// ID 21 and command 13: gains times 1000.
struct ControllerGains {
  std::uint8_t type = 0;  ///< 0 factory default, 1 user
  std::uint32_t kp_milli = 100000;
  std::uint32_t ki_milli = 100;
  std::uint32_t kd_milli = 2000;
};

/// The sub-payloads of one frame.
struct Feedback {
  std::optional<CoreSensors> core;
  std::optional<DockInfrared> dock_infrared;
  std::optional<Inertia> inertia;
  std::optional<CliffAdc> cliff_adc;
  std::optional<MotorCurrent> current;
  std::optional<Version> hardware;
  std::optional<Version> firmware;
  std::optional<RawGyro> gyro;
  std::optional<EepromData> eeprom;
  std::optional<GeneralInput> input;
  std::optional<UniqueId> unique_id;
  std::optional<ControllerGains> gains;
};

/// Reads every sub-payload of a payload that passed the checksum. What is unknown, malformed or cut
/// off is left out and counted; the rest of the frame is still read.
[[nodiscard]] Feedback decode_feedback(ByteView payload, DecodeCounts& counts);

/// The frame of a base, in the order of real bases: 1,3,4,5,6,13,16, then 10,11,15,19,21.
[[nodiscard]] Frame encode_feedback(const Feedback& feedback);

}  // namespace tocsin::kobuki
