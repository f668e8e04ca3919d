// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/command.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "frames.hpp"

namespace tocsin::kobuki {
namespace {

Bytes encoded(const Command& command) { return to_bytes(encode_command(command).bytes()); }

std::vector<Command> decoded(const Bytes& payload, DecodeCounts& counts) {
  std::vector<Command> commands;
  decode_commands(view(payload), counts, [&](const Command& c) { commands.push_back(c); });
  return commands;
}

OutputRegister with_led(int led, bool red, bool green) {
  OutputRegister outputs;
  outputs.set_led(led, red, green);
  return outputs;
}

// The frames that the reference driver sends (reference page 1.4).
TEST(Command, HasTheBytesOfTheReference) {
  EXPECT_EQ(encoded(BaseControl{100, 0}), from_hex("AA5506010464000000 67"));
  EXPECT_EQ(encoded(Tone{413, 200}), from_hex("AA550503039D01C8 51"));
  EXPECT_EQ(encoded(Tune::error), from_hex("AA5503040104 02"));
  EXPECT_EQ(encoded(RequestExtra{0x0B}), from_hex("AA550409020B00 04"));
  EXPECT_EQ(encoded(with_led(1, false, true)), from_hex("AA55040C02F002 F8"));
  EXPECT_EQ(encoded(SetGains{{1, 100000, 100, 2000}}),
            from_hex("AA550F0D0D01A086010064000000D0070000 9A"));
  EXPECT_EQ(encoded(GetGains{}), from_hex("AA55030E0100 0C"));
}

TEST(Command, DecodesWhatItEncodes) {
  const std::vector<Command> commands{BaseControl{-157, 32767},
                                      Tone{826, 255},
                                      Tune::cleaning_end,
                                      RequestExtra{0x0B},
                                      OutputRegister{0x0FF0},
                                      SetGains{{0, 1, 2, 0xFFFFFFFF}},
                                      GetGains{},
                                      ChangeFrame{9},
                                      RequestEeprom{8}};
  for (const Command& command : commands) {
    const Frame frame = encode_command(command);
    DecodeCounts counts;
    const auto back = decoded(to_bytes(frame.payload()), counts);
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back[0].index(), command.index());
    EXPECT_EQ(encoded(back[0]), to_bytes(frame.bytes()));
    EXPECT_EQ(counts.known, 1U);
  }
}

TEST(Command, CountsUnknownMalformedAndTruncated) {
  DecodeCounts counts;
  EXPECT_EQ(decoded(from_hex("02 01 00  01 03 000000  04 01 07  04 01 06  0e 01"), counts).size(),
            1U);
  EXPECT_EQ(counts.unknown, 1U);
  EXPECT_EQ(counts.malformed, 2U);  // base control of 3 bytes, tune 7
  EXPECT_EQ(counts.known, 1U);
  EXPECT_EQ(counts.truncated, 1U);
}

TEST(Command, DoesNotOverfillAFrame) {
  Frame frame;
  int appended = 0;
  while (append(frame, SetGains{})) ++appended;
  EXPECT_EQ(appended, 17);  // 17 * 15 = 255
  EXPECT_FALSE(append(frame, GetGains{}));
  frame.close();
  EXPECT_EQ(frame.bytes().size, max_frame);
}

TEST(OutputRegister, ChangesOnlyTheNamedBits) {
  OutputRegister sut;
  EXPECT_EQ(sut.bits, 0x00F0) << "all supplies on";
  sut.set_supply(2, false);
  EXPECT_EQ(sut.bits, 0x00B0);
  sut.set_output(3, true);
  sut.set_led(2, true, true);
  EXPECT_EQ(sut.bits, 0x0CB8);
  sut.set_led(2, false, true);
  sut.set_output(3, false);
  sut.set_supply(2, true);
  EXPECT_EQ(sut.bits, 0x08F0);
}

TEST(Note, FollowsTheFormulaWithinItsRange) {
  for (const auto& [frequency_hz, note] :
       {std::pair(440.0, 826), {880, 413}, {261.63, 1389}, {0, 0}, {-5, 0}, {1, 65535}}) {
    EXPECT_EQ(note_of(frequency_hz), note) << frequency_hz;
  }
  EXPECT_NEAR(frequency_of(826), 440, 0.5);
  EXPECT_EQ(frequency_of(0), 0);
}

TEST(Command, SurvivesRandomPayloads) {
  std::mt19937 random(8);
  DecodeCounts counts;
  for (int i = 0; i < 100000; ++i) {
    Bytes payload(random() % 64);
    for (auto& byte : payload) byte = static_cast<std::uint8_t>(random() % 16);
    for (const Command& command : decoded(payload, counts)) (void)encode_command(command);
  }
  EXPECT_GT(counts.known, 0U);
}

}  // namespace
}  // namespace tocsin::kobuki
