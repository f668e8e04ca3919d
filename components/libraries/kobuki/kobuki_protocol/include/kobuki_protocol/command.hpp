// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "kobuki_protocol/feedback.hpp"
#include "kobuki_protocol/frame.hpp"

namespace tocsin::kobuki {

/// ID 1: wheel motion in the base's own terms, see velocity.hpp.
struct BaseControl {
  std::int16_t speed_mm_s = 0;
  std::int16_t radius_mm = 0;
};

/// ID 3: a tone.
struct Tone {
  std::uint16_t note = 0;  ///< see note_of()
  std::uint8_t duration_ms = 0;
};

/// ID 4: one of the seven built-in tunes.
enum class Tune : std::uint8_t { on, off, recharge, button, error, cleaning_start, cleaning_end };

/// ID 9: asks for versions and id; the answer is in the next feedback frame.
struct RequestExtra {
  static constexpr std::uint16_t hardware = 0x01;
  static constexpr std::uint16_t firmware = 0x02;
  static constexpr std::uint16_t unique_id = 0x08;
  std::uint16_t flags = 0;
};

/// ID 12: outputs, supplies and LEDs are one register that is written whole. Keep a copy: a
/// careless write of 0 cuts the power of the computer on the robot.
struct OutputRegister {
  static constexpr std::uint16_t start = 0x00F0;  ///< all supplies on
  std::uint16_t bits = start;

  /// Open-drain output 0 to 3.
  void set_output(int index, bool on);
  /// Supply 0: 3.3 V, 1: 5 V, 2: 12 V 5 A, 3: 12 V 1.5 A.
  void set_supply(int index, bool on);
  /// LED 1 or 2.
  void set_led(int led, bool red, bool green);
};

/// ID 13, firmware from 1.2.
struct SetGains {
  ControllerGains gains;
};

/// ID 14, firmware from 1.2: answered by feedback 21.
struct GetGains {};

/// IDs 10 and 11; declared by the vendor, never used.
struct ChangeFrame {
  std::uint8_t frame_id = 0;
};
struct RequestEeprom {
  std::uint8_t frame_id = 0;
};

using Command = std::variant<BaseControl, Tone, Tune, RequestExtra, OutputRegister, SetGains,
                             GetGains, ChangeFrame, RequestEeprom>;

/// The note number of a frequency: 1 / (f * 2.75 us), rounded down, within u16. 440 Hz is 826.
/// A frequency that is not positive gives 0.
[[nodiscard]] std::uint16_t note_of(double frequency_hz);
/// The inverse; 0 for note 0.
[[nodiscard]] double frequency_of(std::uint16_t note);

/// Appends one command. False when the frame is full; nothing is written then.
[[nodiscard]] bool append(Frame& frame, const Command& command);

/// A closed frame with one command.
[[nodiscard]] Frame encode_command(const Command& command);

/// The command in a sub-payload; empty when unknown or malformed, which is counted.
[[nodiscard]] std::optional<Command> decode_command(const SubPayload& sub, DecodeCounts& counts);

/// Calls `sink(const Command&)` for each command of a payload that passed the checksum.
template <class Sink>
void decode_commands(ByteView payload, DecodeCounts& counts, Sink&& sink) {
  SubPayloadReader reader(payload);
  while (const auto sub = reader.next()) {
    if (const auto command = decode_command(*sub, counts)) sink(*command);
  }
  if (reader.truncated()) ++counts.truncated;
}

}  // namespace tocsin::kobuki
