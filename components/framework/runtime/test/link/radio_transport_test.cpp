// SPDX-License-Identifier: Apache-2.0
#include "link/radio_transport.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <vector>

#include "link/origin.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t data = 0x15;
constexpr std::uint8_t fragment = 0x16;
constexpr std::uint8_t acknack = 0x06;
constexpr std::uint8_t heartbeat = 0x07;
constexpr std::uint8_t info_timestamp = 0x09;

/// The header of an RTPS message.
Bytes message() {
  Bytes bytes{'R', 'T', 'P', 'S', 2, 3, 1, 15};
  bytes.resize(20);
  return bytes;
}

void append(Bytes& to, std::uint8_t kind, const Bytes& content, bool little_endian = true) {
  const auto low = static_cast<std::uint8_t>(content.size() & 0xFFU);
  const auto high = static_cast<std::uint8_t>(content.size() >> 8U);
  to.insert(to.end(), {kind, static_cast<std::uint8_t>(little_endian ? 1 : 0),
                       little_endian ? low : high, little_endian ? high : low});
  to.insert(to.end(), content.begin(), content.end());
}

/// Extra flags and octets to inline QoS, reader, writer, and something behind.
Bytes data_of(std::uint8_t writer) {
  return {0, 0, 16, 0, 0, 0, 0, 0, 0, 0, writer, 0x03, 1, 2, 3, 4, 5, 6, 7, 8};
}
/// Reader, writer, and something behind.
Bytes ends(std::uint8_t reader, std::uint8_t writer) {
  return {0, 0, reader, 0x04, 0, 0, writer, 0x03, 0, 0, 0, 0};
}

std::uint32_t sender(const Bytes& bytes) {
  const auto found = sender_in(bytes.data(), bytes.size());
  return found ? wire_id_of(*found) : 0;
}

TEST(SenderIn, DataAndFragmentsComeFromTheirWriter) {
  for (const std::uint8_t kind : {data, fragment}) {
    Bytes bytes = message();
    append(bytes, kind, data_of(7));
    EXPECT_EQ(sender(bytes), 0x0703U);
  }
}

TEST(SenderIn, AHeartbeatComesFromItsWriterAndAnAcknackFromItsReader) {
  Bytes bytes = message();
  append(bytes, heartbeat, ends(5, 9));
  EXPECT_EQ(sender(bytes), 0x0903U);
  bytes = message();
  append(bytes, acknack, ends(5, 9));
  EXPECT_EQ(sender(bytes), 0x0504U);
}

TEST(SenderIn, PassesWhatNamesNoEndpoint) {
  Bytes bytes = message();
  append(bytes, info_timestamp, Bytes(8));
  append(bytes, data, data_of(7));
  EXPECT_EQ(sender(bytes), 0x0703U);
}

TEST(SenderIn, ReadsLengthsOfEitherByteOrder) {
  Bytes bytes = message();
  append(bytes, info_timestamp, Bytes(8), false);
  append(bytes, data, data_of(7), false);
  EXPECT_EQ(sender(bytes), 0x0703U);
}

TEST(SenderIn, FindsNothingWhereThereIsNothing) {
  EXPECT_EQ(sender({}), 0U);
  EXPECT_EQ(sender(message()), 0U);
  Bytes last = message();
  append(last, info_timestamp, {});  // length 0: until the end
  EXPECT_EQ(sender(last), 0U);
  Bytes cut = message();
  append(cut, data, data_of(7));
  cut.resize(20 + 4 + 11);
  EXPECT_EQ(sender(cut), 0U);
}

TEST(SenderIn, NeverReadsBeyondItsBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 20000; ++i) {
    Bytes bytes(random() % 80);  // its own piece of memory: a sanitizer sees a read behind it
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 32);
    (void)sender_in(bytes.data(), bytes.size());
  }
}

TEST(RadioMarks, APacketBearsTheMarkOfItsWriter) {
  RadioMarks sut;
  rtps::EntityId_t writer;
  writer.value[2] = 7;
  writer.value[3] = 3;
  Bytes bytes = message();
  append(bytes, data, data_of(7));
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size()), 48) << "not known yet";
  sut.set(writer, 8);
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size()), 8);
  sut.forget(writer);
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size()), 48);
}

TEST(RadioMarks, DiscoveryGoesFirstAndIsCounted) {
  RadioMarks sut;
  Bytes announcement = message();
  Bytes content = data_of(1);
  content[11] = 0xc2;  // the kind of a built-in writer
  append(announcement, data, content);
  Bytes sample = message();
  append(sample, data, data_of(7));
  EXPECT_EQ(sut.mark(announcement.data(), announcement.size()), 48);
  (void)sut.mark(sample.data(), sample.size());
  (void)sut.mark(sample.data(), sample.size());
  const LinkPackets packets = sut.packets();
  EXPECT_EQ(packets.packets, 3U);
  EXPECT_EQ(packets.discovery_packets, 1U);
  EXPECT_EQ(packets.discovery_bytes, announcement.size() + 28);
  EXPECT_EQ(packets.bytes, announcement.size() + 2 * sample.size() + 3 * 28);
}

}  // namespace
}  // namespace tocsin
