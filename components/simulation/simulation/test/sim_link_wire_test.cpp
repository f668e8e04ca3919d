// SPDX-License-Identifier: Apache-2.0
// What routers of simulated hosts put on the air.
#include <gtest/gtest.h>

#include "link_bus_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin::simulation {
namespace {

/// Around a whole sample: IP and UDP, RTPS header, destination, time stamp, DATA, the origin as
/// inline QoS.
constexpr std::size_t around_sample = 28 + 20 + 16 + 12 + 24 + 32;
/// The same around a fragment, whose DATA_FRAG is longer by 12.
constexpr std::size_t around_fragment = around_sample + 12;
constexpr std::size_t most_of_a_fragment = 1400 - 20 - 16 - 12 - 36 - 32 - 32 - 60;
constexpr std::size_t announcement = 486;

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

LinkPackets operator-(const LinkPackets& one, const LinkPackets& other) {
  return {one.packets - other.packets, one.bytes - other.bytes,
          one.discovery_packets - other.discovery_packets,
          one.discovery_bytes - other.discovery_bytes};
}

class LinkWireTest : public LinkBusTest {
 protected:
  /// What the vehicle's router sends for a picture with so many bytes of data.
  LinkPackets packets_of_picture(std::size_t data_bytes) {
    connect();
    const auto writer = payload_.advertise(endpoint<topic::CameraImage>());
    run_for(0.2);
    const LinkPackets before = up().bus.packets();
    (void)writer->write(picture(data_bytes));
    run_for(0.1);
    return up().bus.packets() - before;
  }
  static std::size_t serialized(std::size_t data_bytes) {
    return type_info<topic::CameraImage::Message>().serialized_size(picture(data_bytes).get());
  }
  /// Data of a picture that is so long when it is serialised.
  static std::size_t data_of(std::size_t serialized_bytes) {
    return serialized_bytes - serialized(0);
  }
};

TEST_F(LinkWireTest, EachFragmentOfASampleIsAPacketWithTheOrigin) {
  for (const std::size_t data_bytes : {std::size_t{100}, data_of(most_of_a_fragment),
                                       data_of(most_of_a_fragment + 1), std::size_t{20000}}) {
    const std::size_t size = serialized(data_bytes);
    const std::size_t fragments = (size + most_of_a_fragment - 1) / most_of_a_fragment;
    const LinkPackets sent = packets_of_picture(data_bytes);
    EXPECT_EQ(sent.packets, fragments) << data_bytes;
    const std::size_t around = fragments == 1 ? around_sample : around_fragment;
    EXPECT_EQ(sent.bytes, fragments * around + padded(size)) << data_bytes;
    EXPECT_LE(sent.bytes, fragments * (28U + 1400U));
  }
}

TEST_F(LinkWireTest, EachPieceOfASampleIsAPacketWithAHeaderMore) {
  connect();
  const FlowId flow = up().bus.open({}, TrafficClass::low);
  CarriedSample sample = up().bus.pack(type_info<topic::CameraImage::Message>(), picture(20000));
  const LinkPackets before = up().bus.packets();
  const SamplePiece piece{3, 20};
  ASSERT_TRUE(up().bus.send(flow, sample, piece, 0));
  const LinkPackets after = up().bus.packets();
  EXPECT_EQ(after.packets - before.packets, 1U);
  EXPECT_EQ(after.bytes - before.bytes, around_sample + padded(piece.size(sample.bytes) + 4));
}

TEST_F(LinkWireTest, ASampleIsWholeWhenItsLastPacketHasCome) {
  connect();
  Reader& away = read<topic::CameraImage>(view_);
  const auto writer = payload_.advertise(endpoint<topic::CameraImage>());
  run_for(0.2);
  link_.faults(0).loss = 1;
  (void)writer->write(picture(20000));
  run_for(0.1);
  link_.faults(0).loss = 0.2;  // of 18 packets hardly all come
  (void)writer->write(picture(20000));
  run_for(0.1);
  EXPECT_TRUE(away.samples.empty());
  link_.faults(0).loss = 0;
  (void)writer->write(picture(20000));
  run_for(0.1);
  ASSERT_EQ(away.samples.size(), 1U);
  EXPECT_EQ(away.samples[0].sequence, 3U);
}

TEST_F(LinkWireTest, PacketsThatTheAirDoublesMakeOneTransmission) {
  connect();
  Reader& away = read<topic::CameraImage>(view_);
  const auto writer = payload_.advertise(endpoint<topic::CameraImage>());
  run_for(0.2);
  link_.faults(0).duplication = 1;
  (void)writer->write(picture(20000));
  run_for(0.1);
  EXPECT_EQ(down().count<link_event::LinkSample>(), 1U);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(LinkWireTest, ARouterWithoutAPeerSendsNothing) {
  start(uxv_);
  write<topic::Location>(drive_);
  run_for(10);
  EXPECT_EQ(link_.pushed(), 0U);
  EXPECT_EQ(up().bus.packets().packets, 0U);
}

TEST_F(LinkWireTest, EachRouterAnnouncesItselfEachSecond) {
  connect();
  run_for(0.79);
  EXPECT_EQ(up().bus.packets().discovery_packets, 0U);
  run_for(0.01);
  EXPECT_EQ(up().bus.packets().discovery_packets, 1U);
  run_for(9);
  for (const PlainRouter* one : {&up(), &down()}) {
    const LinkPackets sent = one->bus.packets();
    EXPECT_EQ(sent.discovery_packets, 10U);
    EXPECT_EQ(sent.discovery_bytes, 10 * announcement);
    EXPECT_EQ(sent.packets, 10U);
    EXPECT_EQ(sent.bytes, 10 * announcement);
  }
}

TEST_F(LinkWireTest, ADeadRouterAnnouncesNothingAndItsSuccessorOnce) {
  connect();
  kill_router(uxv_);
  std::uint64_t before = link_.pushed();
  run_for(10);
  EXPECT_EQ(link_.pushed() - before, 10U);  // the other one's
  start(uxv_);
  run_for(0.5);
  before = link_.pushed();
  run_for(10);
  EXPECT_EQ(link_.pushed() - before, 20U);
}

TEST_F(LinkWireTest, PacketsCountTheRadiosPackets) {
  connect();
  const auto writer = payload_.advertise(endpoint<topic::CameraImage>());
  for (int i = 0; i < 20; ++i) {
    (void)writer->write(picture(20000));
    run_for(0.5);
  }
  EXPECT_EQ(up().bus.packets().packets + down().bus.packets().packets, link_.pushed());
}

TEST_F(LinkWireTest, AMessageBetweenRoutersIsUnpackedAsItWasPacked) {
  connect();
  const TypeInfo& type = type_info<topic::Goal::Message>();
  const auto packed = message<topic::Goal>();
  const CarriedSample sample = up().bus.pack(type, packed);
  EXPECT_EQ(sample.bytes, type.serialized_size(packed.get()));
  Flow between;
  between.topic = link_acknowledgement_topic;
  const FlowId flow = up().bus.open(between, TrafficClass::critical);
  run_for(0.2);
  EXPECT_EQ(up().bus.send(flow, sample, {}, 0), 1U);
  core_.now += seconds(0.01);
  link_.advance();
  const auto event = down().bus.take();
  ASSERT_TRUE(event);
  ASSERT_TRUE(std::holds_alternative<link_event::LinkSample>(*event));
  EXPECT_EQ(down().bus.unpack(type, std::get<link_event::LinkSample>(*event).sample), packed);
}

}  // namespace
}  // namespace tocsin::simulation
