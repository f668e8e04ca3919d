// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "rplidar_protocol/request.hpp"

namespace tocsin::rplidar {

/// Who the device is.
struct Info {
  std::uint8_t model = 0;  ///< 0x18: A1M8, 0x28: A2M8
  std::uint8_t firmware_major = 0;
  std::uint8_t firmware_minor = 0;
  std::uint8_t hardware = 0;
  std::array<std::uint8_t, 16> serial{};
};
/// "model 0x18, firmware 1.29, hardware 7, serial 0123..."
[[nodiscard]] std::string to_text(const Info& info);

struct Health {
  enum class Status : std::uint8_t { good = 0, warning = 1, error = 2 };
  Status status = Status::good;
  std::uint16_t code = 0;
};

/// The device's own measure, before it is a scan.
struct Reading {
  double angle_rad = 0;  ///< clockwise from ahead, seen from above [range 0,2 pi)
  double range_m = 0;    ///< 0: no return
  int quality = 0;       ///< of the returned light [range 0,63]; express scans have none: 0
  bool begins_turn = false;
};

/// Kinds of answers by the byte of their descriptor.
enum class AnswerType : std::uint8_t {
  info = 0x04,
  health = 0x06,
  scan = 0x81,
  express = 0x82,
};
constexpr std::size_t descriptor_size = 7;
constexpr std::size_t reading_size = 5;
constexpr std::size_t capsule_size = 84;
constexpr std::size_t capsule_readings = 32;
/// Of what follows a descriptor; of scans, of each part [bytes].
[[nodiscard]] std::size_t size_of(AnswerType type);

/// What a device sends, for simulated ones.
[[nodiscard]] Bytes descriptor(AnswerType type);
[[nodiscard]] Bytes encode(const Info& info);
[[nodiscard]] Bytes encode(const Health& health);
/// The angle is rounded to 1/64 degree, the range to 0.25 mm and held at 16.38 m.
[[nodiscard]] Bytes encode(const Reading& reading);
/// Of 32 readings at angles that rise evenly from `start_rad`; ranges are rounded to 1 mm.
/// `begins`: the first capsule of a scan.
[[nodiscard]] Bytes encode_capsule(double start_rad,
                                   const std::array<double, capsule_readings>& ranges_m,
                                   bool begins);

/// The fields of 5 bytes whose check bits are right.
[[nodiscard]] bool is_reading(ByteView bytes);
[[nodiscard]] Reading decode_reading(ByteView bytes);
[[nodiscard]] Info decode_info(ByteView bytes);
[[nodiscard]] Health decode_health(ByteView bytes);

/// The angle within [0, 2 pi).
[[nodiscard]] double whole_turn(double angle_rad);

}  // namespace tocsin::rplidar
