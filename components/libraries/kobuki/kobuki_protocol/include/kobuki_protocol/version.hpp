// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin::kobuki {

/// A hardware or firmware version as the base reports it.
struct Version {
  std::uint8_t major = 0;
  std::uint8_t minor = 0;
  std::uint8_t patch = 0;
  /// The code of the old 2-byte form (firmware before 1.1.2), when it came or shall go out so.
  std::optional<std::uint16_t> old_code;
};

/// Ordered by major, minor, patch; the form on the wire does not matter.
[[nodiscard]] bool operator<(const Version& a, const Version& b);
[[nodiscard]] bool operator==(const Version& a, const Version& b);

/// "1.2.0".
[[nodiscard]] std::string to_text(const Version& version);

/// Old 2-byte codes: 104 is 1.0.4; the firmware codes 123, 110 or 10100, 111 or 10101 are 1.0.0,
/// 1.1.0, 1.1.1 (reference page 1.3).
[[nodiscard]] Version hardware_from_old_code(std::uint16_t code);
[[nodiscard]] Version firmware_from_old_code(std::uint16_t code);

/// What to think of a firmware version. Recommended are 1.1.4 and 1.2.0 (reference page 1.8).
enum class FirmwareSupport {
  recommended,
  replace,          ///< older than recommended, or between two recommended ones
  software_behind,  ///< newer than all that this software knows
  refused           ///< major is not 1: another protocol
};
[[nodiscard]] FirmwareSupport judge_firmware(const Version& firmware);

/// Whether the firmware has user gains (commands 13 and 14, feedback 21): from 1.2.0.
[[nodiscard]] bool has_gains(const Version& firmware);

/// Feature bits of VersionInfo: 1 smooth start, 2 three-axis gyro, both after 1.0.0.
[[nodiscard]] std::uint64_t feature_bits(const Version& firmware);

}  // namespace tocsin::kobuki
