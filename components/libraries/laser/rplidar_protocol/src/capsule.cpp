// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/capsule.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

// A capsule: 2 bytes of sync nibbles and checksum, 2 of the start angle (q6, its top bit: the scan
// begins), then 16 cabins of 5 bytes: two distances of 14 bits in mm, whose low bits are the top
// two of each correction, and one byte with the low four bits of both (q3 degrees, signed).
constexpr std::size_t cabin_size = 5;
constexpr double mm = 0.001;

double correction_rad(unsigned high_bits, unsigned low_bits) {
  const unsigned raw = (high_bits & 3U) << 4U | (low_bits & 0xFU);
  const int signed_raw = raw >= 32 ? static_cast<int>(raw) - 64 : static_cast<int>(raw);
  return signed_raw * degree / 8;
}

std::uint8_t checksum(ByteView bytes) {
  std::uint8_t sum = 0;
  for (std::size_t i = 2; i < capsule_size; ++i) sum ^= bytes[i];
  return sum;
}

unsigned u16(ByteView bytes, std::size_t at) {
  return bytes[at] | static_cast<unsigned>(bytes[at + 1]) << 8U;
}

}  // namespace

bool is_capsule(ByteView bytes) {
  return bytes[0] >> 4U == 0xA && bytes[1] >> 4U == 0x5 &&
         ((bytes[0] & 0xFU) | (bytes[1] & 0xFU) << 4U) == checksum(bytes);
}

Capsule decode_capsule(ByteView bytes) {
  Capsule capsule;
  const unsigned start = u16(bytes, 2);
  capsule.begins = (start & 0x8000U) != 0;
  capsule.start_rad = whole_turn((start & 0x7FFFU) * degree / 64);
  for (std::size_t i = 0; i < capsule_readings; ++i) {
    const std::size_t cabin = 4 + i / 2 * cabin_size;
    const unsigned distance = u16(bytes, cabin + i % 2 * 2);
    const unsigned low_bits = bytes[cabin + 4] >> (i % 2 * 4);
    capsule.ranges_m[i] = (distance >> 2U) * mm;
    capsule.corrections_rad[i] = correction_rad(distance, low_bits);
  }
  return capsule;
}

std::array<Reading, capsule_readings> readings_of(const Capsule& capsule, double next_start_rad) {
  const double step_rad = whole_turn(next_start_rad - capsule.start_rad) / capsule_readings;
  std::array<Reading, capsule_readings> readings;
  for (std::size_t i = 0; i < capsule_readings; ++i) {
    const double raw_rad = capsule.start_rad + static_cast<double>(i) * step_rad;
    const bool begins =
        std::floor(raw_rad / (2 * pi)) != std::floor((raw_rad - step_rad) / (2 * pi));
    readings[i] = {whole_turn(raw_rad - capsule.corrections_rad[i]), capsule.ranges_m[i], 0,
                   begins};
  }
  return readings;
}

Bytes encode_capsule(double start_rad, const std::array<double, capsule_readings>& ranges_m,
                     bool begins) {
  Bytes bytes(capsule_size, 0);
  const auto put = [&bytes](std::size_t at, unsigned value) {
    bytes[at] = static_cast<std::uint8_t>(value & 0xFFU);
    bytes[at + 1] = static_cast<std::uint8_t>(value >> 8U);
  };
  const auto start = static_cast<unsigned>(std::lround(whole_turn(start_rad) / degree * 64));
  put(2, start % (360U * 64U) | (begins ? 0x8000U : 0U));
  for (std::size_t i = 0; i < capsule_readings; ++i) {
    const auto distance =
        static_cast<unsigned>(std::clamp(std::lround(ranges_m[i] / mm), 0L, 0x3FFFL));
    put(4 + i / 2 * cabin_size + i % 2 * 2, distance << 2U);
  }
  const std::uint8_t sum = checksum({bytes.data(), bytes.size()});
  bytes[0] = static_cast<std::uint8_t>(0xA0U | (sum & 0xFU));
  bytes[1] = static_cast<std::uint8_t>(0x50U | sum >> 4U);
  return bytes;
}

}  // namespace tocsin::rplidar
