// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/feedback.hpp"

#include <gtest/gtest.h>

#include "frames.hpp"
#include "kobuki_protocol/gyro.hpp"

namespace tocsin::kobuki {
namespace {

struct Decoded {
  Feedback feedback;
  DecodeCounts counts;
};

Decoded decode(const Bytes& payload) {
  Decoded result;
  result.feedback = decode_feedback(view(payload), result.counts);
  return result;
}

Decoded decode_hex(const std::string& payload) { return decode(from_hex(payload)); }

/// Core sensors with a number in each field.
const std::string core_hex = "01 0f 8ff1 05 02 03 00ed 2b58 f3 0d 04 16 9f 02 ";

TEST(Feedback, ReadsEveryCoreField) {
  const auto core = decode_hex(core_hex).feedback.core;
  ASSERT_TRUE(core);
  EXPECT_EQ(core->timestamp_ms, 0xF18F);
  EXPECT_EQ(core->bumper, left_bit | right_bit);
  EXPECT_EQ(core->wheel_drop, left_wheel_drop_bit);
  EXPECT_EQ(core->cliff, right_bit | centre_bit);
  EXPECT_EQ(core->left_encoder, 0xED00);
  EXPECT_EQ(core->right_encoder, 0x582B);
  EXPECT_EQ(core->left_pwm, -13);
  EXPECT_EQ(core->right_pwm, 13);
  EXPECT_EQ(core->buttons, 4);
  EXPECT_EQ(core->charger, 22);
  EXPECT_EQ(core->battery_dv, 159);
  EXPECT_EQ(core->over_current, right_over_current_bit);
}

TEST(Feedback, ReadsTheOtherSensors) {
  const auto sut = decode_hex(
      "03 03 01 08 20  04 07 3c1d fcff 000000  05 06 f506 f507 9006  06 02 01 02 "
      "10 10 0f00 dc0f 0100 0200 0300 ef0f 0000 0000");
  EXPECT_EQ(sut.counts.known, 5U);
  EXPECT_EQ(sut.feedback.dock_infrared->right, 1);
  EXPECT_EQ(sut.feedback.dock_infrared->centre, 8);
  EXPECT_EQ(sut.feedback.dock_infrared->left, 32);
  EXPECT_EQ(sut.feedback.inertia->angle_cdeg, 7484);
  EXPECT_EQ(sut.feedback.inertia->angle_rate_cdps, -4);
  EXPECT_EQ(sut.feedback.cliff_adc->right, 0x06F5);  // the wire is right first
  EXPECT_EQ(sut.feedback.cliff_adc->centre, 0x07F5);
  EXPECT_EQ(sut.feedback.cliff_adc->left, 0x0690);
  EXPECT_EQ(sut.feedback.current->left, 1);
  EXPECT_EQ(sut.feedback.current->right, 2);
  EXPECT_EQ(sut.feedback.input->digital, 15);
  EXPECT_EQ(sut.feedback.input->analog[0], 4060);
  EXPECT_EQ(sut.feedback.input->analog[3], 3);
}

TEST(Feedback, ReadsVersionsIdAndGains) {
  const auto sut = decode_hex(
      "0a 04 04 00 01 00  0b 04 00 02 01 00  13 0c 01000000 02000000 ffffffff "
      "15 0d 01 a0860100 64000000 d0070000");
  EXPECT_EQ(to_text(*sut.feedback.hardware), "1.0.4");
  EXPECT_EQ(to_text(*sut.feedback.firmware), "1.2.0");
  const auto old = decode_hex("0a 02 6800  0b 02 7b00");  // of two bytes
  EXPECT_EQ(to_text(*old.feedback.hardware), "1.0.4");
  EXPECT_EQ(to_text(*old.feedback.firmware), "1.0.0");
  EXPECT_EQ(*sut.feedback.unique_id, (UniqueId{1, 2, 0xFFFFFFFF}));
  EXPECT_EQ(sut.feedback.gains->type, 1);
  EXPECT_EQ(sut.feedback.gains->kp_milli, 100000U);
  EXPECT_EQ(sut.feedback.gains->ki_milli, 100U);
  EXPECT_EQ(sut.feedback.gains->kd_milli, 2000U);
}

TEST(Feedback, ReadsTwoAndThreeGyroSamples) {
  const auto two = decode_hex("0d 0e 81 06 a1ff 0800 c8ff 90ff 0300 cfff").feedback.gyro;
  ASSERT_TRUE(two);
  EXPECT_EQ(two->frame_id, 0x81);
  EXPECT_EQ(two->count, 2);
  EXPECT_EQ(two->samples[0].x, -95);
  EXPECT_EQ(two->samples[1].z, -49);
  const auto three = decode_hex("0d 14 81 09 0100 0200 0300 0400 0500 0600 0700 0800 0900");
  EXPECT_EQ(three.feedback.gyro->count, 3);
  EXPECT_EQ(three.feedback.gyro->samples[2].z, 9);
}

TEST(Feedback, BoundsTheGyroSamples) {
  // 60 and 110 words silence or crash the reference driver (reference page 3.4).
  for (const unsigned words : {27U, 60U, 110U, 123U}) {
    Bytes payload{0x0D, static_cast<std::uint8_t>(2 + 2 * words), 7,
                  static_cast<std::uint8_t>(words)};
    payload.resize(4 + 2 * words, 0x5A);
    const auto sut = decode(payload);
    EXPECT_FALSE(sut.feedback.gyro) << words;
    EXPECT_EQ(sut.counts.malformed, 1U) << words;
  }
  Bytes most{0x0D, 50, 7, 24};
  most.resize(52, 1);
  EXPECT_EQ(decode(most).feedback.gyro->count, 8);
}

TEST(Feedback, RejectsGyroCountsThatDisagreeWithTheLength) {
  for (const char* bad : {"0d 0e 81 03 a1ff 0800 c8ff 90ff 0300 cfff",
                          "0d 06 81 02 a1ff 0800",  // not a whole sample
                          "0d 01 81", "0d 00 03 03 01 02 03"}) {
    EXPECT_EQ(decode_hex(bad).counts.malformed, 1U) << bad;
  }
}

TEST(Feedback, SkipsUnknownIdsAndReadsTheRest) {
  const auto sut = decode_hex("02 03 aa 55 ff  ff 00  03 03 01 02 04");
  EXPECT_EQ(sut.counts.unknown, 2U);
  EXPECT_EQ(sut.counts.known, 1U);
  EXPECT_TRUE(sut.feedback.dock_infrared);
}

TEST(Feedback, SkipsEveryKnownIdOfWrongLengthAndReadsTheRest) {
  for (const int id : {1, 3, 4, 5, 6, 10, 11, 13, 15, 16, 19, 21}) {
    Bytes payload{static_cast<std::uint8_t>(id), 1, 0xEE};
    append_to(payload, from_hex("02 01 00 06 02 01 02"));
    const auto got = decode(payload);
    EXPECT_EQ(got.counts.malformed, 1U) << id;
    EXPECT_TRUE(got.feedback.current) << id;
  }
}

TEST(Feedback, DropsTheRestWhenALengthRunsPastTheEnd) {
  const auto sut = decode_hex("06 02 01 02  03 04 01 02 03");
  EXPECT_TRUE(sut.feedback.current);
  EXPECT_FALSE(sut.feedback.dock_infrared);
  EXPECT_EQ(sut.counts.truncated, 1U);
  EXPECT_EQ(decode_hex("06 02 01 02 03").counts.truncated, 1U);
  EXPECT_EQ(decode_hex("06 02 01 02").counts.truncated, 0U);
}

Feedback full_feedback() {
  Feedback feedback = typical_feedback(0);
  feedback.gyro->count = RawGyro::max_samples;
  feedback.hardware = Version{1, 0, 4, {}};
  feedback.firmware = firmware_from_old_code(10101);
  feedback.eeprom = EepromData{3, {1, 2, 3}};
  feedback.unique_id = UniqueId{97713968, 842422349, 1361404194};
  feedback.gains = ControllerGains{1, 2, 3, 4};
  return feedback;
}

TEST(Feedback, EncodesWhatItDecodes) {
  const Frame once = encode_feedback(full_feedback());
  DecodeCounts counts;
  const Feedback back = decode_feedback(once.payload(), counts);
  EXPECT_EQ(to_bytes(encode_feedback(back).bytes()), to_bytes(once.bytes()));
  EXPECT_EQ(counts.known, 12U);
  EXPECT_EQ(counts.malformed + counts.unknown + counts.truncated, 0U);
  EXPECT_EQ(back.eeprom->bytes[2], 3);
  EXPECT_EQ(back.gains->kd_milli, 4U);
}

TEST(Feedback, SurvivesRandomPayloads) {
  std::mt19937 random(7);
  DecodeCounts counts;
  for (int i = 0; i < 100000; ++i) {
    Bytes payload(random() % 256);
    for (auto& byte : payload) byte = static_cast<std::uint8_t>(random() % 24);
    const Feedback got = decode_feedback(view(payload), counts);
    ASSERT_LE(got.gyro.value_or(RawGyro{}).count, RawGyro::max_samples);
  }
  EXPECT_GT(counts.malformed, 0U);
  EXPECT_GT(counts.truncated, 0U);
}

TEST(Gyro, TurnsTheAxesOfTheChip) {
  const auto rate = angular_velocity({100, 200, -300});
  EXPECT_DOUBLE_EQ(rate.x_rad_s, -200 * gyro_digit_rad_s);
  EXPECT_DOUBLE_EQ(rate.y_rad_s, 100 * gyro_digit_rad_s);
  EXPECT_DOUBLE_EQ(rate.z_rad_s, -300 * gyro_digit_rad_s);
  EXPECT_NEAR(angular_velocity({0, 0, 1000}).z_rad_s, 8.75 * degree, 1e-12);
}

TEST(Gyro, StampsSamplesTenMillisecondsApart) {
  const Time arrival = Time{} + seconds(1);
  EXPECT_EQ(gyro_sample_time(arrival, 2, 3), arrival);
  EXPECT_EQ(gyro_sample_time(arrival, 0, 3), arrival - std::chrono::milliseconds(20));
}

}  // namespace
}  // namespace tocsin::kobuki
