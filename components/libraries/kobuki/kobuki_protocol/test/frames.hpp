// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

using Bytes = std::vector<std::uint8_t>;

inline ByteView view(const Bytes& bytes) { return {bytes.data(), bytes.size()}; }

inline Bytes to_bytes(ByteView bytes) { return {bytes.begin(), bytes.end()}; }

/// "aa 55 0C" or "aa550c".
inline Bytes from_hex(const std::string& text) {
  Bytes bytes;
  std::string digits;
  for (const char c : text) {
    if (c == ' ') continue;
    digits += c;
    if (digits.size() < 2) continue;
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits, nullptr, 16)));
    digits.clear();
  }
  return bytes;
}

inline void append_to(Bytes& to, const Bytes& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// A frame as a real base sends it, every 20 ms, number `i`.
inline Feedback typical_feedback(int i) {
  Feedback feedback;
  CoreSensors core;
  core.timestamp_ms = static_cast<std::uint16_t>(20 * i);
  core.left_encoder = static_cast<std::uint16_t>(65500 + 7 * i);
  core.right_encoder = static_cast<std::uint16_t>(8 * i);
  core.battery_dv = 158;
  feedback.core = core;
  feedback.dock_infrared = DockInfrared{};
  feedback.inertia = Inertia{static_cast<std::int16_t>(i * 13), 21};
  feedback.cliff_adc = CliffAdc{1781, 1782, 1936};
  feedback.current = MotorCurrent{1, 2};
  RawGyro gyro;
  gyro.frame_id = static_cast<std::uint8_t>(2 * i);
  gyro.count = i % 7 == 0 ? 3 : 2;
  gyro.samples[0] = {static_cast<std::int16_t>(i), -1, 8};
  feedback.gyro = gyro;
  GeneralInput input;
  input.analog = {4060, 4062, 4064, 4066};
  input.unused = {4079, 0, 0};
  feedback.input = input;
  return feedback;
}

inline Bytes typical_frame(int i) { return to_bytes(encode_feedback(typical_feedback(i)).bytes()); }

}  // namespace tocsin::kobuki
