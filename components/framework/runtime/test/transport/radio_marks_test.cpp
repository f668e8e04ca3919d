// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_marks.hpp"

#include <gtest/gtest.h>

#include "link/rtps_bytes.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

/// The writer of `data_of(7)`.
rtps::EntityId_t writer_7() {
  rtps::EntityId_t writer;
  writer.value[2] = 7;
  writer.value[3] = 3;
  return writer;
}

Bytes message_of_writer_7() {
  Bytes bytes = message();
  append(bytes, data, data_of(7));
  return bytes;
}

TEST(RadioMarks, APacketBearsTheMarkOfItsWriter) {
  RadioMarks sut;
  const rtps::EntityId_t writer = writer_7();
  Bytes bytes = message_of_writer_7();
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size(), bytes.size()).dscp, 48) << "not known yet";
  sut.set(writer, {8, TrafficClass::low, {}});
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size(), bytes.size()).dscp, 8);
  sut.forget(writer);
  EXPECT_EQ(sut.mark(bytes.data(), bytes.size(), bytes.size()).dscp, 48);
}

TEST(RadioMarks, AWritersPacketsTakeItsPathAndDiscoveryTakesBoth) {
  RadioMarks sut;
  Bytes bytes = message_of_writer_7();
  const auto paths = [&] { return sut.mark(bytes.data(), bytes.size(), bytes.size()).paths; };
  EXPECT_EQ(paths(), (std::array{true, false}));
  sut.add_path();
  EXPECT_EQ(paths(), (std::array{true, true})) << "of a writer that is not known";
  sut.set(writer_7(), {8, TrafficClass::low, {}, 1});
  EXPECT_EQ(paths(), (std::array{false, true}));
  sut.set(writer_7(), {8, TrafficClass::low, {}, 0});
  EXPECT_EQ(paths(), (std::array{true, false}));
  EXPECT_EQ(sut.packets().bytes, 5 * (bytes.size() + 28));
  EXPECT_EQ(sut.packets().second_bytes, 2 * (bytes.size() + 28));
}

TEST(RadioMarks, TheBytesOfAWriterCountForItsClassAlsoWhenItIsForgotten) {
  RadioMarks sut;
  const rtps::EntityId_t writer = writer_7();
  Bytes bytes = message_of_writer_7();
  (void)sut.mark(bytes.data(), bytes.size(), bytes.size());
  sut.set(writer, {32, TrafficClass::high, {}});
  (void)sut.mark(bytes.data(), bytes.size(), bytes.size());
  (void)sut.mark(bytes.data(), bytes.size(), bytes.size());
  sut.forget(writer);
  const auto& by_class = sut.packets().class_bytes;
  EXPECT_EQ(by_class[1], 2 * (bytes.size() + 28));
  EXPECT_EQ(by_class[0] + by_class[2] + by_class[3], 0U);
}

TEST(RadioMarks, BytesAreCountedByWhatTheyAreFor) {
  RadioMarks sut;
  const rtps::EntityId_t writer = writer_7();
  Bytes bytes = message_of_writer_7();
  sut.set(writer, {48, TrafficClass::critical, LinkPurpose::acknowledgements});
  (void)sut.mark(bytes.data(), bytes.size(), 100);
  sut.note_rider(40, 0);
  sut.set(writer, {8, TrafficClass::low, LinkPurpose::backfill});
  (void)sut.mark(bytes.data(), bytes.size(), 1000);
  EXPECT_EQ(sut.mark_stop(60, 0), 48);
  const LinkPackets packets = sut.packets();
  EXPECT_EQ(packets.acknowledgement_bytes, 128U);
  EXPECT_EQ(packets.backfill_bytes, 1028U);
  EXPECT_EQ(packets.stop_bytes, 40U + 88U) << "in a packet of another, and in one of its own";
  EXPECT_EQ(packets.bytes, 128U + 1028U + 40U + 88U);
  EXPECT_EQ(packets.packets, 3U);
  EXPECT_EQ(packets.class_bytes[0], 128U) << "without the stop's";
}

TEST(RadioMarks, DiscoveryGoesFirstAndIsCounted) {
  RadioMarks sut;
  Bytes announcement = message();
  Bytes content = data_of(1);
  content[11] = 0xc2;  // the kind of a built-in writer
  append(announcement, data, content);
  Bytes sample = message();
  append(sample, data, data_of(7));
  EXPECT_EQ(sut.mark(announcement.data(), announcement.size(), announcement.size()).dscp, 48);
  (void)sut.mark(sample.data(), sample.size(), sample.size());
  (void)sut.mark(sample.data(), sample.size(), sample.size());
  const LinkPackets packets = sut.packets();
  EXPECT_EQ(packets.packets, 3U);
  EXPECT_EQ(packets.discovery_packets, 1U);
  EXPECT_EQ(packets.discovery_bytes, announcement.size() + 28);
  EXPECT_EQ(packets.bytes, announcement.size() + 2 * sample.size() + 3 * 28);
}

TEST(RadioMarks, WhatWritersSendDoesNotGoToMutedAddressesAndDiscoveryDoes) {
  RadioMarks sut;
  Bytes bytes = message_of_writer_7();
  sut.mute({5});
  EXPECT_FALSE(sut.withholds(bytes.data(), bytes.size(), 5)) << "of no writer that is known";
  sut.set(writer_7(), {8, TrafficClass::low, {}});
  EXPECT_TRUE(sut.withholds(bytes.data(), bytes.size(), 5));
  EXPECT_FALSE(sut.withholds(bytes.data(), bytes.size(), 6));
  sut.mute({});
  EXPECT_FALSE(sut.withholds(bytes.data(), bytes.size(), 5));
}

}  // namespace
}  // namespace tocsin
