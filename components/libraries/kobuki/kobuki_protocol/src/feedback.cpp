// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/feedback.hpp"

#include "feedback_ids.hpp"
#include "gains.hpp"

namespace tocsin::kobuki {
namespace {

enum class Outcome { known, unknown, malformed };

CoreSensors read_core(ByteReader in) {
  CoreSensors core;
  core.timestamp_ms = in.u16();
  core.bumper = in.u8();
  core.wheel_drop = in.u8();
  core.cliff = in.u8();
  core.left_encoder = in.u16();
  core.right_encoder = in.u16();
  core.left_pwm = in.i8();
  core.right_pwm = in.i8();
  core.buttons = in.u8();
  core.charger = in.u8();
  core.battery_dv = in.u8();
  core.over_current = in.u8();
  return core;
}

DockInfrared read_dock(ByteReader in) {
  DockInfrared dock;
  dock.right = in.u8();
  dock.centre = in.u8();
  dock.left = in.u8();
  return dock;
}

Inertia read_inertia(ByteReader in) {
  Inertia inertia;
  inertia.angle_cdeg = in.i16();
  inertia.angle_rate_cdps = in.i16();
  return inertia;
}

CliffAdc read_cliff(ByteReader in) {
  CliffAdc cliff;
  cliff.right = in.u16();
  cliff.centre = in.u16();
  cliff.left = in.u16();
  return cliff;
}

MotorCurrent read_current(ByteReader in) {
  MotorCurrent current;
  current.left = in.u8();
  current.right = in.u8();
  return current;
}

Version read_new_version(ByteReader in) {
  Version version;
  version.patch = in.u8();
  version.minor = in.u8();
  version.major = in.u8();
  return version;
}

EepromData read_eeprom(ByteReader in) {
  EepromData eeprom;
  eeprom.frame_id = in.u8();
  for (std::uint8_t& byte : eeprom.bytes) byte = in.u8();
  return eeprom;
}

GeneralInput read_input(ByteReader in) {
  GeneralInput input;
  input.digital = in.u16();
  for (std::uint16_t& value : input.analog) value = in.u16();
  for (std::uint16_t& value : input.unused) value = in.u16();
  return input;
}

UniqueId read_unique_id(ByteReader in) {
  UniqueId id{};
  for (std::uint32_t& word : id) word = in.u32();
  return id;
}

template <class T>
Outcome take(ByteView data, std::size_t size, T (*read)(ByteReader), std::optional<T>& to) {
  if (data.size != size) return Outcome::malformed;
  to = read(ByteReader(data));
  return Outcome::known;
}

Outcome take_version(ByteView data, Version (*from_old)(std::uint16_t),
                     std::optional<Version>& to) {
  if (data.size != 2) return take(data, 4, read_new_version, to);
  to = from_old(ByteReader(data).u16());
  return Outcome::known;
}

Outcome take_gyro(ByteView data, std::optional<RawGyro>& to) {
  if (data.size < 2) return Outcome::malformed;
  ByteReader in(data);
  RawGyro gyro;
  gyro.frame_id = in.u8();
  const std::size_t words = in.u8();
  if (data.size != 2 + 2 * words || words % 3 != 0) return Outcome::malformed;
  if (words > 3 * RawGyro::max_samples) return Outcome::malformed;
  gyro.count = static_cast<std::uint8_t>(words / 3);
  for (std::size_t i = 0; i < gyro.count; ++i) {
    gyro.samples[i].x = in.i16();
    gyro.samples[i].y = in.i16();
    gyro.samples[i].z = in.i16();
  }
  to = gyro;
  return Outcome::known;
}

Outcome decode_one(const SubPayload& sub, Feedback& to) {
  switch (sub.id) {
    case id::core:
      return take(sub.data, size::core, read_core, to.core);
    case id::dock:
      return take(sub.data, size::dock, read_dock, to.dock_infrared);
    case id::inertia:
      return take(sub.data, size::inertia, read_inertia, to.inertia);
    case id::cliff:
      return take(sub.data, size::cliff, read_cliff, to.cliff_adc);
    case id::current:
      return take(sub.data, size::current, read_current, to.current);
    case id::hardware:
      return take_version(sub.data, hardware_from_old_code, to.hardware);
    case id::firmware:
      return take_version(sub.data, firmware_from_old_code, to.firmware);
    case id::gyro:
      return take_gyro(sub.data, to.gyro);
    case id::eeprom:
      return take(sub.data, size::eeprom, read_eeprom, to.eeprom);
    case id::input:
      return take(sub.data, size::input, read_input, to.input);
    case id::unique_id:
      return take(sub.data, size::unique_id, read_unique_id, to.unique_id);
    case id::gains:
      return take(sub.data, size::gains, read_gains, to.gains);
    default:
      return Outcome::unknown;
  }
}

}  // namespace

Feedback decode_feedback(ByteView payload, DecodeCounts& counts) {
  Feedback feedback;
  SubPayloadReader reader(payload);
  while (const auto sub = reader.next()) {
    const Outcome outcome = decode_one(*sub, feedback);
    if (outcome == Outcome::known) ++counts.known;
    if (outcome == Outcome::unknown) ++counts.unknown;
    if (outcome == Outcome::malformed) ++counts.malformed;
  }
  if (reader.truncated()) ++counts.truncated;
  return feedback;
}

}  // namespace tocsin::kobuki
