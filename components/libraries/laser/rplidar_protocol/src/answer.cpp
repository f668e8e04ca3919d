// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

constexpr double angle_unit = degree / 64;
constexpr double range_unit_m = 0.00025;

}  // namespace

double whole_turn(double angle_rad) {
  const double rest = std::fmod(angle_rad, 2 * pi);
  return rest < 0 ? rest + 2 * pi : rest;
}

std::size_t size_of(AnswerType type) {
  switch (type) {
    case AnswerType::info:
      return 20;
    case AnswerType::health:
      return 3;
    case AnswerType::scan:
      return reading_size;
    case AnswerType::express:
      break;
  }
  return capsule_size;
}

Bytes descriptor(AnswerType type) {
  const bool goes_on = type == AnswerType::scan || type == AnswerType::express;
  return {0xA5,
          0x5A,
          static_cast<std::uint8_t>(size_of(type)),
          0,
          0,
          static_cast<std::uint8_t>(goes_on ? 0x40 : 0),
          static_cast<std::uint8_t>(type)};
}

Bytes encode(const Info& info) {
  Bytes bytes(size_of(AnswerType::info));
  bytes[0] = info.model;
  bytes[1] = info.firmware_minor;
  bytes[2] = info.firmware_major;
  bytes[3] = info.hardware;
  std::copy(info.serial.begin(), info.serial.end(), bytes.begin() + 4);
  return bytes;
}

Bytes encode(const Health& health) {
  return {static_cast<std::uint8_t>(health.status), static_cast<std::uint8_t>(health.code & 0xFFU),
          static_cast<std::uint8_t>(health.code >> 8U)};
}

Bytes encode(const Reading& reading) {
  const auto angle =
      static_cast<unsigned>(std::lround(whole_turn(reading.angle_rad) / angle_unit)) % (360U * 64U);
  const auto range =
      static_cast<unsigned>(std::clamp(std::lround(reading.range_m / range_unit_m), 0L, 0xFFFFL));
  const unsigned first =
      static_cast<unsigned>(reading.quality) << 2U | (reading.begins_turn ? 1U : 2U);
  return {static_cast<std::uint8_t>(first), static_cast<std::uint8_t>((angle << 1U | 1U) & 0xFFU),
          static_cast<std::uint8_t>(angle >> 7U), static_cast<std::uint8_t>(range & 0xFFU),
          static_cast<std::uint8_t>(range >> 8U)};
}

bool is_reading(ByteView bytes) {
  const bool begins = (bytes[0] & 1U) != 0;
  const bool goes_on = (bytes[0] & 2U) != 0;
  const unsigned angle = bytes[1] >> 1U | static_cast<unsigned>(bytes[2]) << 7U;
  return begins != goes_on && (bytes[1] & 1U) != 0 && angle < 360U * 64U;
}

Reading decode_reading(ByteView bytes) {
  const unsigned angle = bytes[1] >> 1U | static_cast<unsigned>(bytes[2]) << 7U;
  const unsigned range = bytes[3] | static_cast<unsigned>(bytes[4]) << 8U;
  return {angle * angle_unit, range * range_unit_m, bytes[0] >> 2U, (bytes[0] & 1U) != 0};
}

Info decode_info(ByteView bytes) {
  Info info{bytes[0], bytes[2], bytes[1], bytes[3], {}};
  std::copy(bytes.begin() + 4, bytes.begin() + 20, info.serial.begin());
  return info;
}

Health decode_health(ByteView bytes) {
  const std::uint8_t status = std::min<std::uint8_t>(bytes[0], 2);
  return {static_cast<Health::Status>(status),
          static_cast<std::uint16_t>(bytes[1] | static_cast<unsigned>(bytes[2]) << 8U)};
}

std::string to_text(const Info& info) {
  std::string serial;
  for (const std::uint8_t byte : info.serial) serial += fmt::format("{:02X}", byte);
  return fmt::format("model 0x{:02X}, firmware {}.{:02}, hardware {}, serial {}", info.model,
                     info.firmware_major, info.firmware_minor, info.hardware, serial);
}

}  // namespace tocsin::rplidar
