// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/decoder.hpp"

#include <gtest/gtest.h>

#include <random>

#include "foundation/numbers.hpp"

namespace tocsin::rplidar {
namespace {

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

struct Decoded {
  std::vector<Answer> answers;
  Decoder::Counts counts;
  [[nodiscard]] std::vector<Reading> readings() const {
    std::vector<Reading> found;
    for (const Answer& one : answers) {
      if (const auto* reading = std::get_if<Reading>(&one)) found.push_back(*reading);
    }
    return found;
  }
};

Decoded decode(const Bytes& bytes, std::size_t portion = 7) {
  Decoder sut;
  Decoded decoded;
  const ByteView all{bytes.data(), bytes.size()};
  for (std::size_t at = 0; at < bytes.size(); at += portion) {
    sut.feed(all.part(at, std::min(portion, bytes.size() - at)),
             [&](const Answer& answer) { decoded.answers.push_back(answer); });
  }
  decoded.counts = sut.counts();
  return decoded;
}

/// `count` readings a degree apart from 90.5 degrees on, 1 m away.
Bytes readings(int count, double first_deg = 90.5) {
  std::vector<Bytes> parts;
  for (int i = 0; i < count; ++i)
    parts.push_back(encode(Reading{(first_deg + i) * degree, 1, 47, false}));
  return joined(parts);
}

// Written by hand from the tables of the protocol: not by our encoder.
const Bytes scan_descriptor{0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, 0x81};

TEST(Decoder, ReadsAReadingByTheTableOfTheProtocol) {
  // Quality 47, begins a turn; 90.5 degrees are 5792 / 64; 1000 mm are 4000 / 4. Then 91.5 degrees.
  const Bytes first{0xBD, 0x41, 0x2D, 0xA0, 0x0F};
  const Bytes second{0xBE, 0xC1, 0x2D, 0x00, 0x00};
  const auto found = decode(joined({scan_descriptor, first, second, readings(2, 92.5)})).readings();
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NEAR(found[0].angle_rad, 90.5 * degree, 1e-12);
  EXPECT_NEAR(found[0].range_m, 1, 1e-12);
  EXPECT_EQ(found[0].quality, 47);
  EXPECT_TRUE(found[0].begins_turn);
  EXPECT_NEAR(found[1].angle_rad, 91.5 * degree, 1e-12);
  EXPECT_EQ(found[1].range_m, 0);
  EXPECT_FALSE(found[1].begins_turn);
}

TEST(Decoder, ReadsInfoAndHealthByTheTableOfTheProtocol) {
  Bytes info{0xA5, 0x5A, 0x14, 0x00, 0x00, 0x00, 0x04, 0x18, 0x1D, 0x01, 0x07};
  for (std::uint8_t i = 0; i < 16; ++i) info.push_back(i);
  const Bytes health{0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06, 0x02, 0x34, 0x12};
  const auto found = decode(joined({info, health})).answers;
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(to_text(std::get<Info>(found[0])),
            "model 0x18, firmware 1.29, hardware 7, serial 000102030405060708090A0B0C0D0E0F");
  EXPECT_EQ(std::get<Health>(found[1]).status, Health::Status::error);
  EXPECT_EQ(std::get<Health>(found[1]).code, 0x1234);
}

TEST(Decoder, ReadsACapsuleByTheTableOfTheProtocol) {
  // Starts at 10 degrees (640 / 64). First cabin: 1000 mm corrected by 1 degree, 500 mm by -0.5.
  Bytes capsule(84, 0);
  capsule[2] = 0x80;
  capsule[3] = 0x82;  // 0x0280, and the scan begins
  capsule[4] = 0xA0;
  capsule[5] = 0x0F;
  capsule[6] = 0xD3;
  capsule[7] = 0x07;
  capsule[8] = 0xC8;
  const std::uint8_t sum = 0x80 ^ 0x82 ^ 0xA0 ^ 0x0F ^ 0xD3 ^ 0x07 ^ 0xC8;
  capsule[0] = 0xA0 | (sum & 0xF);
  capsule[1] = 0x50 | sum >> 4;
  const Bytes head{0xA5, 0x5A, 0x54, 0x00, 0x00, 0x40, 0x82};
  const auto next = encode_capsule(26 * degree, {}, false);
  const auto found = decode(joined({head, capsule, next})).readings();
  ASSERT_EQ(found.size(), 32U);
  EXPECT_NEAR(found[0].angle_rad, 9 * degree, 1e-9);
  EXPECT_NEAR(found[0].range_m, 1, 1e-9);
  EXPECT_NEAR(found[1].angle_rad, (10 + 0.5 + 0.5) * degree, 1e-9);
  EXPECT_NEAR(found[1].range_m, 0.5, 1e-9);
  EXPECT_NEAR(found[31].angle_rad, (10 + 15.5) * degree, 1e-9);
  EXPECT_EQ(found[31].range_m, 0);
}

TEST(Decoder, CapsulesBeginATurnWhereTheyPassAhead) {
  const Bytes bytes =
      joined({descriptor(AnswerType::express), encode_capsule(350.25 * degree, {}, true),
              encode_capsule(6.25 * degree, {}, false), encode_capsule(22.25 * degree, {}, false)});
  const auto found = decode(bytes).readings();
  ASSERT_EQ(found.size(), 64U);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].begins_turn, i == 20) << i;
}

TEST(Decoder, FindsAnswersBehindAGreetingAndGarbage) {
  const std::string greeting = "RP LIDAR System.\r\nFirmware Ver 1.29\r\n\xA5\x5A\x05\xA5";
  const Bytes noise(greeting.begin(), greeting.end());
  for (const std::size_t portion : {1U, 3U, 1000U}) {
    const auto found = decode(joined({noise, scan_descriptor, readings(10)}), portion);
    EXPECT_EQ(found.readings().size(), 10U) << portion;
    EXPECT_EQ(found.counts.discarded, noise.size());
  }
}

/// A byte that is lost or damaged costs the readings around it: what follows is right.
TEST(Decoder, GivesNoReadingThatIsWrongAfterABadByte) {
  std::mt19937 random(3);  // NOLINT: a fixed seed is the point
  for (int trial = 0; trial < 300; ++trial) {
    Bytes bytes = readings(60, 5);
    const std::size_t at = random() % (bytes.size() - 50);
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    if (trial % 3 == 0) bytes.erase(place);
    if (trial % 3 == 1) bytes.insert(place, static_cast<std::uint8_t>(random()));
    if (trial % 3 == 2) *place = static_cast<std::uint8_t>(random());
    const auto found = decode(joined({scan_descriptor, bytes})).readings();
    EXPECT_GE(found.size(), 50U) << trial;
    int odd = 0;
    for (const Reading& one : found) {
      const double deg = one.angle_rad / degree;
      odd += std::abs(deg - std::round(deg)) > 1e-6 || std::abs(one.range_m - 1) > 1e-9;
    }
    EXPECT_LE(odd, trial % 3 == 2 ? 1 : 2) << trial << ": what its check bits do not show";
  }
}

TEST(Decoder, ADamagedCapsuleCostsItAndTheOneBefore) {
  std::vector<Bytes> parts{descriptor(AnswerType::express)};
  for (int i = 0; i < 6; ++i) parts.push_back(encode_capsule(i * 16 * degree, {}, i == 0));
  EXPECT_EQ(decode(joined(parts)).readings().size(), 5U * 32);
  parts[3][40] ^= 1;
  const auto found = decode(joined(parts));
  EXPECT_EQ(found.readings().size(), 3U * 32);
  EXPECT_EQ(found.counts.rejected, 1U);
}

TEST(Decoder, AnswersToAnotherRequestAreFoundInTheMiddleOfAScan) {
  for (const AnswerType type : {AnswerType::scan, AnswerType::express}) {
    const Bytes part = type == AnswerType::scan ? readings(10) : encode_capsule(0, {}, true);
    const auto found = decode(joined({descriptor(type), part, descriptor(AnswerType::health),
                                      encode(Health{Health::Status::warning, 7})}));
    ASSERT_FALSE(found.answers.empty());
    const auto* health = std::get_if<Health>(&found.answers.back());
    ASSERT_NE(health, nullptr);
    EXPECT_EQ(health->code, 7);
  }
}

TEST(Decoder, KeepsNoMoreThanItNeedsOfNoise) {
  std::mt19937 random(5);  // NOLINT: a fixed seed is the point
  Decoder sut;
  std::size_t answers = 0;
  for (int i = 0; i < 2000; ++i) {
    Bytes noise(64);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(random());
    sut.feed({noise.data(), noise.size()}, [&](const Answer&) { ++answers; });
  }
  EXPECT_EQ(answers, 0U);
  EXPECT_GE(sut.counts().discarded, 2000U * 64 - capsule_size);
}

}  // namespace
}  // namespace tocsin::rplidar
