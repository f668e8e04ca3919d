// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include "feedback_ids.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {
namespace {

/// All sub-payloads together take 173 bytes, so none can fail to fit.
ByteWriter begin(Frame& frame, std::uint8_t id, std::size_t size) {
  auto out = frame.begin(id, size);
  assert(out);
  return *out;
}

void write(Frame& frame, const CoreSensors& core) {
  ByteWriter out = begin(frame, id::core, size::core);
  out.u16(core.timestamp_ms);
  out.u8(core.bumper);
  out.u8(core.wheel_drop);
  out.u8(core.cliff);
  out.u16(core.left_encoder);
  out.u16(core.right_encoder);
  out.i8(core.left_pwm);
  out.i8(core.right_pwm);
  out.u8(core.buttons);
  out.u8(core.charger);
  out.u8(core.battery_dv);
  out.u8(core.over_current);
}

void write(Frame& frame, const DockInfrared& dock) {
  ByteWriter out = begin(frame, id::dock, size::dock);
  out.u8(dock.right);
  out.u8(dock.centre);
  out.u8(dock.left);
}

void write(Frame& frame, const Inertia& inertia) {
  ByteWriter out = begin(frame, id::inertia, size::inertia);
  out.i16(inertia.angle_cdeg);
  out.i16(inertia.angle_rate_cdps);
  for (int i = 0; i < 3; ++i) out.u8(0);
}

void write(Frame& frame, const CliffAdc& cliff) {
  ByteWriter out = begin(frame, id::cliff, size::cliff);
  out.u16(cliff.right);
  out.u16(cliff.centre);
  out.u16(cliff.left);
}

void write(Frame& frame, const MotorCurrent& current) {
  ByteWriter out = begin(frame, id::current, size::current);
  out.u8(current.left);
  out.u8(current.right);
}

void write(Frame& frame, const RawGyro& gyro) {
  assert(gyro.count <= RawGyro::max_samples);
  ByteWriter out = begin(frame, id::gyro, 2 + 6U * gyro.count);
  out.u8(gyro.frame_id);
  out.u8(static_cast<std::uint8_t>(3 * gyro.count));
  for (std::size_t i = 0; i < gyro.count; ++i) {
    out.i16(gyro.samples[i].x);
    out.i16(gyro.samples[i].y);
    out.i16(gyro.samples[i].z);
  }
}

void write(Frame& frame, const GeneralInput& input) {
  ByteWriter out = begin(frame, id::input, size::input);
  out.u16(input.digital);
  for (const std::uint16_t value : input.analog) out.u16(value);
  for (const std::uint16_t value : input.unused) out.u16(value);
}

void write_version(Frame& frame, std::uint8_t id, const Version& version) {
  ByteWriter out = begin(frame, id, version.old_code ? 2 : 4);
  if (version.old_code) {
    out.u16(*version.old_code);
    return;
  }
  out.u8(version.patch);
  out.u8(version.minor);
  out.u8(version.major);
  out.u8(0);
}

void write(Frame& frame, const EepromData& eeprom) {
  ByteWriter out = begin(frame, id::eeprom, size::eeprom);
  out.u8(eeprom.frame_id);
  for (const std::uint8_t byte : eeprom.bytes) out.u8(byte);
}

void write(Frame& frame, const UniqueId& unique_id) {
  ByteWriter out = begin(frame, id::unique_id, size::unique_id);
  for (const std::uint32_t word : unique_id) out.u32(word);
}

void write(Frame& frame, const ControllerGains& gains) {
  ByteWriter out = begin(frame, id::gains, size::gains);
  out.u8(gains.type);
  out.u32(gains.kp_milli);
  out.u32(gains.ki_milli);
  out.u32(gains.kd_milli);
}

template <class T>
void write_if(Frame& frame, const std::optional<T>& part) {
  if (part) write(frame, *part);
}

}  // namespace

Frame encode_feedback(const Feedback& feedback) {
  Frame frame;
  write_if(frame, feedback.core);
  write_if(frame, feedback.dock_infrared);
  write_if(frame, feedback.inertia);
  write_if(frame, feedback.cliff_adc);
  write_if(frame, feedback.current);
  write_if(frame, feedback.gyro);
  write_if(frame, feedback.input);
  if (feedback.hardware) write_version(frame, id::hardware, *feedback.hardware);
  if (feedback.firmware) write_version(frame, id::firmware, *feedback.firmware);
  write_if(frame, feedback.eeprom);
  write_if(frame, feedback.unique_id);
  write_if(frame, feedback.gains);
  frame.close();
  return frame;
}

}  // namespace tocsin::kobuki
