// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/command.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "gains.hpp"

namespace tocsin::kobuki {
namespace {

constexpr double note_period_s = 0.00000275;  // reference page 1.4

void set_bits(std::uint16_t& bits, unsigned mask, bool on) {
  bits = static_cast<std::uint16_t>(on ? (bits | mask) : (bits & ~mask));
}

/// Writes the sub-payload of each kind; false when it does not fit.
struct Writer {
  Frame& frame;

  bool operator()(const BaseControl& c) {
    auto out = frame.begin(1, 4);
    if (!out) return false;
    out->i16(c.speed_mm_s);
    out->i16(c.radius_mm);
    return true;
  }
  bool operator()(const Tone& c) {
    auto out = frame.begin(3, 3);
    if (!out) return false;
    out->u16(c.note);
    out->u8(c.duration_ms);
    return true;
  }
  bool operator()(Tune c) { return byte(4, static_cast<std::uint8_t>(c)); }
  bool operator()(const RequestExtra& c) { return word(9, c.flags); }
  bool operator()(const OutputRegister& c) { return word(12, c.bits); }
  bool operator()(const SetGains& c) {
    auto out = frame.begin(13, 13);
    if (!out) return false;
    out->u8(c.gains.type);
    out->u32(c.gains.kp_milli);
    out->u32(c.gains.ki_milli);
    out->u32(c.gains.kd_milli);
    return true;
  }
  bool operator()(const GetGains&) { return byte(14, 0); }
  bool operator()(const ChangeFrame& c) { return byte(10, c.frame_id); }
  bool operator()(const RequestEeprom& c) { return byte(11, c.frame_id); }

 private:
  bool byte(std::uint8_t id, std::uint8_t value) {
    auto out = frame.begin(id, 1);
    if (!out) return false;
    out->u8(value);
    return true;
  }
  bool word(std::uint8_t id, std::uint16_t value) {
    auto out = frame.begin(id, 2);
    if (!out) return false;
    out->u16(value);
    return true;
  }
};

std::size_t size_of(std::uint8_t id) {
  switch (id) {
    case 1:
      return 4;
    case 3:
      return 3;
    case 4:
    case 10:
    case 11:
    case 14:
      return 1;
    case 9:
    case 12:
      return 2;
    case 13:
      return 13;
    default:
      return 0;
  }
}

Command read_base_control(ByteReader in) {
  BaseControl c;
  c.speed_mm_s = in.i16();
  c.radius_mm = in.i16();
  return c;
}

Command read_tone(ByteReader in) {
  Tone c;
  c.note = in.u16();
  c.duration_ms = in.u8();
  return c;
}

std::optional<Command> read_tune(ByteReader in) {
  const std::uint8_t value = in.u8();
  if (value > static_cast<std::uint8_t>(Tune::cleaning_end)) return std::nullopt;
  return static_cast<Tune>(value);
}

std::optional<Command> read(const SubPayload& sub) {
  ByteReader in(sub.data);
  switch (sub.id) {
    case 1:
      return read_base_control(in);
    case 3:
      return read_tone(in);
    case 4:
      return read_tune(in);
    case 9:
      return RequestExtra{in.u16()};
    case 10:
      return ChangeFrame{in.u8()};
    case 11:
      return RequestEeprom{in.u8()};
    case 12:
      return OutputRegister{in.u16()};
    case 13:
      return SetGains{read_gains(in)};
    default:
      return GetGains{};
  }
}

}  // namespace

void OutputRegister::set_output(int index, bool on) {
  assert(index >= 0 && index <= 3);
  set_bits(bits, 0x0001U << static_cast<unsigned>(index), on);
}

void OutputRegister::set_supply(int index, bool on) {
  assert(index >= 0 && index <= 3);
  set_bits(bits, 0x0010U << static_cast<unsigned>(index), on);
}

void OutputRegister::set_led(int led, bool red, bool green) {
  assert(led == 1 || led == 2);
  const unsigned shift = led == 1 ? 8 : 10;
  set_bits(bits, 1U << shift, red);
  set_bits(bits, 2U << shift, green);
}

std::uint16_t note_of(double frequency_hz) {
  if (!(frequency_hz > 0)) return 0;
  return static_cast<std::uint16_t>(std::min(1.0 / (frequency_hz * note_period_s), 65535.0));
}

double frequency_of(std::uint16_t note) { return note == 0 ? 0 : 1.0 / (note * note_period_s); }

bool append(Frame& frame, const Command& command) { return std::visit(Writer{frame}, command); }

Frame encode_command(const Command& command) {
  Frame frame;
  const bool fits = append(frame, command);
  assert(fits);
  frame.close();
  return frame;
}

std::optional<Command> decode_command(const SubPayload& sub, DecodeCounts& counts) {
  const std::size_t expected = size_of(sub.id);
  if (expected == 0) {
    ++counts.unknown;
    return std::nullopt;
  }
  auto command = sub.data.size == expected ? read(sub) : std::nullopt;
  ++(command ? counts.known : counts.malformed);
  return command;
}

}  // namespace tocsin::kobuki
