// SPDX-License-Identifier: Apache-2.0
#include "icmp_packet.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tocsin::network {
namespace {

const Echo echo{0x1234, 0xabcd, 0x0102030405060708ULL};

/// The packet that a peer sends back: type 0, checksum renewed.
std::vector<std::uint8_t> reply_to(std::vector<std::uint8_t> packet) {
  packet[0] = 0;
  packet[2] = packet[3] = 0;
  const std::uint16_t sum = internet_checksum(packet.data(), packet.size());
  packet[2] = static_cast<std::uint8_t>(sum >> 8);
  packet[3] = static_cast<std::uint8_t>(sum & 0xff);
  return packet;
}

TEST(InternetChecksum, MatchesTheExampleOfRfc1071) {
  const std::uint8_t words[] = {0x00, 0x01, 0xf2, 0x03, 0xf4, 0xf5, 0xf6, 0xf7};
  EXPECT_EQ(internet_checksum(words, sizeof words), static_cast<std::uint16_t>(~0xddf2));
}

TEST(InternetChecksum, PadsAnOddLastByteOnTheRight) {
  const std::uint8_t odd[] = {0x12, 0x34, 0x56};
  const std::uint8_t even[] = {0x12, 0x34, 0x56, 0x00};
  EXPECT_EQ(internet_checksum(odd, 3), internet_checksum(even, 4));
  EXPECT_EQ(internet_checksum(odd, 0), 0xffff);
}

TEST(EchoRequest, HasTheLayoutOfRfc792) {
  const auto sut = encode_echo_request(echo, 64);
  ASSERT_EQ(sut.size(), 72U);
  EXPECT_EQ(sut[0], 8);
  EXPECT_EQ(sut[1], 0);
  EXPECT_EQ((std::vector<std::uint8_t>{sut.begin() + 4, sut.begin() + 10}),
            (std::vector<std::uint8_t>{0x12, 0x34, 0xab, 0xcd, 0x01, 0x02}));
  EXPECT_EQ(internet_checksum(sut.data(), sut.size()), 0);
}

TEST(EchoReply, GivesBackWhatTheRequestCarried) {
  const auto packet = reply_to(encode_echo_request(echo, 64));
  const auto sut = decode_echo_reply(packet.data(), packet.size());
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->id, echo.id);
  EXPECT_EQ(sut->sequence, echo.sequence);
  EXPECT_EQ(sut->token, echo.token);
}

TEST(EchoReply, IsNotARequest) {
  const auto packet = encode_echo_request(echo, 64);
  EXPECT_FALSE(decode_echo_reply(packet.data(), packet.size()));
}

TEST(EchoReply, IsRejectedWhenAnyOneBitIsWrong) {
  const auto good = reply_to(encode_echo_request(echo, 64));
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    auto bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
    EXPECT_FALSE(decode_echo_reply(bad.data(), bad.size())) << "bit " << bit;
  }
}

TEST(EchoReply, NeedsRoomForTheToken) {
  const auto small = reply_to(encode_echo_request(echo, min_echo_payload));
  EXPECT_TRUE(decode_echo_reply(small.data(), small.size()));
  for (std::size_t size = 0; size < small.size(); ++size) {
    EXPECT_FALSE(decode_echo_reply(small.data(), size)) << size;
  }
}

TEST(Ipv4Header, IsAsLongAsItSays) {
  std::vector<std::uint8_t> packet(100, 0);
  packet[0] = 0x45;
  EXPECT_EQ(ipv4_header_size(packet.data(), packet.size()), 20U);
  packet[0] = 0x4f;
  EXPECT_EQ(ipv4_header_size(packet.data(), packet.size()), 60U);
  EXPECT_EQ(ipv4_header_size(packet.data(), 60), 60U);
  EXPECT_FALSE(ipv4_header_size(packet.data(), 59));
}

TEST(Ipv4Header, IsRejectedWhenTooShortOrOfAnotherVersion) {
  std::vector<std::uint8_t> packet(100, 0);
  for (const int first : {0x44, 0x65, 0x00}) {
    packet[0] = static_cast<std::uint8_t>(first);
    EXPECT_FALSE(ipv4_header_size(packet.data(), packet.size())) << first;
  }
  packet[0] = 0x45;
  EXPECT_FALSE(ipv4_header_size(packet.data(), 19));
}

TEST(EchoReply, SurvivesAnyBytes) {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::vector<std::uint8_t> bytes(random() % 80);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    if (!bytes.empty()) bytes[0] = 0;
    (void)decode_echo_reply(bytes.data(), bytes.size());
    (void)ipv4_header_size(bytes.data(), bytes.size());
  }
}

}  // namespace
}  // namespace tocsin::network
