// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

/// Feedback sub-payload numbers and data lengths (reference page 1.3).
namespace tocsin::kobuki::id {
inline constexpr std::uint8_t core = 1;
inline constexpr std::uint8_t dock = 3;
inline constexpr std::uint8_t inertia = 4;
inline constexpr std::uint8_t cliff = 5;
inline constexpr std::uint8_t current = 6;
inline constexpr std::uint8_t hardware = 10;
inline constexpr std::uint8_t firmware = 11;
inline constexpr std::uint8_t gyro = 13;
inline constexpr std::uint8_t eeprom = 15;
inline constexpr std::uint8_t input = 16;
inline constexpr std::uint8_t unique_id = 19;
inline constexpr std::uint8_t gains = 21;
}  // namespace tocsin::kobuki::id

namespace tocsin::kobuki::size {
inline constexpr std::size_t core = 15;
inline constexpr std::size_t dock = 3;
inline constexpr std::size_t inertia = 7;
inline constexpr std::size_t cliff = 6;
inline constexpr std::size_t current = 2;
inline constexpr std::size_t eeprom = 17;
inline constexpr std::size_t input = 16;
inline constexpr std::size_t unique_id = 12;
inline constexpr std::size_t gains = 13;
}  // namespace tocsin::kobuki::size
