// SPDX-License-Identifier: Apache-2.0
// Two routers' ways over the link and ordinary peers on both hosts, by real UDP on loopback.
#include "runtime/middleware/link_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "fast_dds/fast_dds_participant.hpp"
#include "fast_dds/rtps_capture.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/topic_registry.hpp"
#include "link/flow_ends.hpp"
#include "link/link_bus_fixture.hpp"
#include "runtime/middleware/refused_names.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

class LinkBusTest : public LinkBusFixture {
 protected:
  LinkBusTest() : LinkBusFixture(next_domain()) {}

 private:
  /// Three after the other: ports of higher domains are such as the kernel gives to anybody.
  static int next_domain() {
    static int next = 0;
    return 31 + 3 * (next++ % 3);
  }
};

TEST_F(LinkBusTest, ASampleCrossesToAnOrdinaryReaderOfTheOtherHostWithItsWriterNumberAndTime) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there)) << "not discovered";
  const auto crossed = gcs.crossed();
  const Sample sample = there.all().front();
  const auto same = std::find_if(crossed.begin(), crossed.end(), [&](const auto& one) {
    return one.sample.sequence == sample.sequence;
  });
  ASSERT_NE(same, crossed.end());
  EXPECT_EQ(sample.source, same->sample.source);
  EXPECT_EQ(sample.sent_wall_ns, same->sample.sent_wall_ns);
  EXPECT_LE(sample.sent_wall_ns, sample.received_wall_ns);
  EXPECT_GT(sample.bytes, 300U);
}

TEST_F(LinkBusTest, ARouterSendsNothingToItselfThoughBothSidesWriteTheTopic) {
  Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples here;
  Samples there;
  const auto near = vehicle->subscribe(endpoint<topic::Heartbeat>(), here);
  const auto far = station->subscribe(endpoint<topic::Heartbeat>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Heartbeat>());
  const auto answer = station->advertise(endpoint<topic::Heartbeat>());
  ASSERT_TRUE(write_until_heard<topic::Heartbeat>(*writer, there));
  ASSERT_TRUE(eventually([&] {
    (void)answer->write(std::make_shared<const topic::Heartbeat::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return !uxv.crossed().empty();
  }));
  const auto sent = [&] {
    const LinkPackets packets = uxv.packets();
    return packets.packets - packets.discovery_packets;
  };
  const auto before = sent();
  const std::size_t crossed = gcs.crossed().size();
  constexpr std::size_t samples = 100;
  for (std::size_t i = 0; i < samples; ++i) {
    (void)writer->write(std::make_shared<const topic::Heartbeat::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_TRUE(eventually([&] { return gcs.crossed().size() >= crossed + samples; }));
  EXPECT_LE(sent() - before, samples + 10);
}

TEST_F(LinkBusTest, EachSideHasANamespaceOfItsOwn) {
  BusOptions station_side = options(Role::gcs);
  station_side.ros_namespace = "uxv3";
  const Relay uxv(options(Role::uxv));
  const Relay gcs(station_side);
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  BusOptions in_namespace = ordinary(Role::gcs);
  in_namespace.ros_namespace = "uxv3";
  const auto its_station = make_fast_dds_bus(in_namespace);
  Samples elsewhere;
  Samples there;
  Samples back;
  const auto other = station->subscribe(endpoint<topic::Location>(), elsewhere);
  const auto far = its_station->subscribe(endpoint<topic::Location>(), there);
  const auto goals = vehicle->subscribe(endpoint<topic::Goal>(), back);
  const auto location = vehicle->advertise(endpoint<topic::Location>());
  const auto goal = its_station->advertise(endpoint<topic::Goal>());
  EXPECT_TRUE(write_until_heard<topic::Location>(*location, there));
  EXPECT_TRUE(write_until_heard<topic::Goal>(*goal, back));
  EXPECT_TRUE(elsewhere.all().empty());
}

TEST_F(LinkBusTest, ALinkToOneVehicleTakesNothingOfAnother) {
  BusOptions station_side = options(Role::gcs);
  station_side.peer_names = {"uxv3"};
  BusOptions right = options(Role::uxv);
  right.host = "uxv3";
  Relay gcs(station_side);
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  {
    Relay stranger(options(Role::uxv));
    ASSERT_TRUE(eventually([&] { return !stranger.peers().empty(); }));
    for (int i = 0; i < 20; ++i) {
      (void)writer->write(std::make_shared<const topic::Location::Message>());
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_THAT(gcs.crossed(), ::testing::IsEmpty());
    EXPECT_THAT(gcs.peers(), ::testing::IsEmpty());
  }
  const Relay uxv(right);
  EXPECT_TRUE(eventually([&] {
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return !gcs.crossed().empty();
  }));
  EXPECT_THAT(gcs.peers(), ::testing::ElementsAre("uxv3"));
}

TEST_F(LinkBusTest, AVelocityThatAPeerSendsIsNotGivenToTheVehicle) {
  const TemporaryFolder folder;
  BusOptions hostile = options(Role::gcs);
  hostile.traffic_file =
      folder.write("traffic.yaml", "uxv: {}\ngcs: {high: {topics: [goal, cmd_vel]}}\n");
  Relay uxv(options(Role::uxv));
  const Relay gcs(hostile);
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples goals;
  Samples velocities;
  const auto hears_goals = vehicle->subscribe(endpoint<topic::Goal>(), goals);
  const auto hears_velocities = vehicle->subscribe(endpoint<topic::CmdVel>(), velocities);
  const auto velocity = station->advertise(endpoint<topic::CmdVel>());
  const auto goal = station->advertise(endpoint<topic::Goal>());
  ASSERT_TRUE(eventually([&] {
    (void)velocity->write(std::make_shared<const topic::CmdVel::Message>());
    (void)goal->write(std::make_shared<const topic::Goal::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return goals.all().size() > 20 && refused_names().lines().count("topic cmd_vel from gcs") != 0;
  }));
  EXPECT_TRUE(velocities.all().empty());
}

TEST_F(LinkBusTest, WhatIsOnDemandCrossesWhileSomebodyOnTheOtherHostReadsIt) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  const auto scan = vehicle->advertise(endpoint<topic::Scan>());
  const auto location = vehicle->advertise(endpoint<topic::Location>());
  Samples scans;
  Samples locations;
  const auto near = station->subscribe(endpoint<topic::Location>(), locations);
  const auto count = [&](Samples& samples) {
    (void)scan->write(std::make_shared<const topic::Scan::Message>());
    (void)location->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return samples.all().size();
  };
  ASSERT_TRUE(eventually([&] { return count(locations) > 20; }));
  const auto crossed = [&] {
    const auto all = gcs.crossed();
    constexpr std::uint32_t between = 200;  // a scan without beams, and a location
    return std::count_if(all.begin(), all.end(),
                         [&](const auto& one) { return one.sample.bytes < between; });
  };
  EXPECT_EQ(crossed(), 0);
  auto far = station->subscribe(endpoint<topic::Scan>(), scans);
  ASSERT_TRUE(eventually([&] { return count(scans) > 5; })) << "it is read";
  far.reset();
  ASSERT_TRUE(eventually([&] {
    const auto before = crossed();
    for (int i = 0; i < 20; ++i) (void)count(locations);
    return crossed() == before;
  })) << "nobody reads it any more";
}

TEST_F(LinkBusTest, APictureCrossesInPiecesOfOnePacketEach) {
  RtpsCapture capture;
  if (!capture.ok()) GTEST_SKIP() << "no packet socket: CAP_NET_RAW is needed";
  Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::CameraImage>(), there);
  // A topic of both sides, which each router writes and reads.
  const auto near = vehicle->advertise(endpoint<topic::Heartbeat>());
  const auto back = station->advertise(endpoint<topic::Heartbeat>());
  ASSERT_TRUE(eventually([&] { return uxv.peer_flows().size() + gcs.peer_flows().size() > 1; }));
  const auto writer = vehicle->advertise(endpoint<topic::CameraImage>());
  const auto image = std::make_shared<topic::CameraImage::Message>();
  for (int i = 0; i < 30'001; ++i) image->data().push_back(static_cast<std::uint8_t>(i % 251));
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(image);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return !there.all().empty();
  }));
  const auto arrived =
      std::static_pointer_cast<const topic::CameraImage::Message>(there.all().front().message);
  EXPECT_EQ(arrived->data(), image->data());
  EXPECT_EQ(gcs.crossed().front().piece.count, 26);
  const int port = 7400 + 250 * options(Role::uxv).link_domain;
  for (const CapturedSubmessage& one : capture.take()) {
    if (one.port < port || one.port >= port + 250) continue;
    EXPECT_LE(one.packet_bytes, 1428U);
    EXPECT_NE(one.kind, 0x16) << "a piece in fragments";
  }
}

TEST_F(LinkBusTest, ACompressedSampleCrossesInFewerBytesAndIsRestored) {
  const Relay uxv(options(Role::uxv), Relay::Compress::yes);
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::CameraImage>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::CameraImage>());
  const auto image = std::make_shared<topic::CameraImage::Message>();
  image->format("jpeg");
  image->data().resize(30'001, 7);
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(image);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return there.all().size() > 3;
  }));
  const auto arrived =
      std::static_pointer_cast<const topic::CameraImage::Message>(there.all().back().message);
  EXPECT_EQ(arrived->data(), image->data());
  const auto crossed = gcs.crossed();
  EXPECT_TRUE(crossed.back().sample.coding.is_compressed);
  EXPECT_GT(crossed.back().sample.coding.base, 0) << "the one before";
  EXPECT_LT(crossed.back().sample.bytes, 200U);
}

TEST_F(LinkBusTest, AReaderOnTheLinkThatIsNoRouterGetsWholePictures) {
  const BusOptions vehicle_options = options(Role::uxv);
  Relay uxv(vehicle_options);
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::CameraImage>());
  FastDdsParticipant outsider(
      {"outsider", vehicle_options.link_domain, "127.0.0.1", {"127.0.0.1"}});
  std::atomic<bool> has_whole{false};
  const TypeInfo& type = type_info<topic::CameraImage::Message>();
  const FlowReader reader(outsider, {"rt/camera/image_raw/compressed", type.name},
                          [&](TakenSample&& taken) {
                            const bool is_whole = taken.piece.is_whole();
                            has_whole = has_whole || (is_whole && taken.sample.bytes > 30'000);
                          });
  const auto image = std::make_shared<topic::CameraImage::Message>();
  image->data().resize(30'000);
  EXPECT_TRUE(eventually([&] {
    (void)writer->write(image);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return has_whole.load();
  }));
}

TEST_F(LinkBusTest, EachTransmissionHasTheNextNumberOfItsFlow) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return gcs.crossed().size() > 20;
  }));
  const auto crossed = gcs.crossed();
  for (std::size_t i = 1; i < crossed.size(); ++i) {
    EXPECT_EQ(crossed[i].number, crossed[i - 1].number + 1);
    EXPECT_EQ(crossed[i].sample.source, crossed[0].sample.source);
  }
}

TEST_F(LinkBusTest, WhatAWriterAnnouncesAndOffersIsKnownOnTheOtherHost) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto station = process(Role::gcs);
  const auto vehicle = process(Role::uxv);
  Samples there;
  const auto far = vehicle->subscribe(endpoint<topic::MissionStatus>(), there);
  const auto writer =
      station->advertise(endpoint<topic::MissionStatus>(topic::EmergencyStop::station));
  ASSERT_TRUE(write_until_heard<topic::MissionStatus>(*writer, there));
  const auto known = far->writer(there.all().front().source);
  ASSERT_TRUE(known);
  EXPECT_THAT(known->user_data, ::testing::HasSubstr(topic::EmergencyStop::station));
  EXPECT_THAT(known->user_data, ::testing::HasSubstr("tocsinlayout="));
  EXPECT_THAT(known->user_data, ::testing::Not(::testing::HasSubstr("tocsinflow=")));
}

TEST_F(LinkBusTest, ALateReaderOfTheOtherHostGetsTheLastSampleOfAState) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::NavigationStatus>());
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(std::make_shared<const topic::NavigationStatus::Message>());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return !gcs.crossed().empty();
  }));
  const auto station = process(Role::gcs);
  Samples late;
  const auto far = station->subscribe(endpoint<topic::NavigationStatus>(), late);
  EXPECT_TRUE(late.wait_for(1));
}

TEST_F(LinkBusTest, AProcessWithoutAnAddressOnTheLinkHasNoWayOverIt) {
  EXPECT_EQ(process(Role::uxv)->link_access(), nullptr);
}

TEST_F(LinkBusTest, PeersKnowEachOtherByTheNameOfTheirHostAndAreMissedWhenTheyLeave) {
  Relay uxv(options(Role::uxv));
  {
    Relay gcs(options(Role::gcs));
    ASSERT_TRUE(eventually([&] { return !uxv.peers().empty() && !gcs.peers().empty(); }));
    EXPECT_THAT(uxv.peers(), ::testing::ElementsAre("gcs"));
    EXPECT_THAT(gcs.peers(), ::testing::ElementsAre("uxv"));
  }
  EXPECT_TRUE(eventually([&] { return uxv.lost_peers() == 1; }));
}

TEST_F(LinkBusTest, WhatIsNotInTheTrafficFileStaysOnItsHost) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  Samples there;
  const auto station = process(Role::gcs);
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto kept = vehicle->advertise(endpoint<topic::Odom>());
  const auto carried = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*carried, there));
  for (const Flow& flow : gcs.peer_flows()) EXPECT_NE(flow.topic, "odom");
}

TEST_F(LinkBusTest, TellsOfEachReaderOfTheHostThatFindsAPeersFlow) {
  const Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(eventually([&] { return !gcs.peer_flows().empty(); }));
  EXPECT_THAT(gcs.heard(), ::testing::IsEmpty());
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  EXPECT_TRUE(eventually([&] { return gcs.heard().size() == 1; }));
}

TEST_F(LinkBusTest, AFlowThatIsNoPeersIsGivenFromTheBytesOfALog) {
  const auto routed = make_fast_dds_bus(options(Role::gcs));
  const auto link = routed->link_access()->open_link([] {});
  const auto station = process(Role::gcs);
  Flow flow;
  flow.topic = topic::Location::info.name + std::string("/backfilled");
  flow.type = type_info<topic::Location::Message>().name;
  flow.reliable = true;
  flow.transient_local = true;
  Endpoint reading = endpoint<topic::Location>();
  reading.topic = make_topic_info(flow.topic, "state", Scope::host);
  Samples there;
  const auto subscription = station->subscribe(reading, there);
  const FlowId on_host = link->offer(flow);
  const auto message = std::make_shared<const topic::Location::Message>();
  const CarriedSample packed = link->pack(type_info<topic::Location::Message>(), message);
  CarriedSample again = link->sample_of(link->bytes_of(packed));
  EXPECT_EQ(again.bytes, packed.bytes);
  again.source = 4711;
  again.sequence = 12;
  again.sent_wall_ns = 1000;
  bool is_heard = false;
  EXPECT_TRUE(eventually([&] {
    while (const auto event = link->take()) {
      const auto* const listens = std::get_if<link_event::HostReaderMatched>(&*event);
      is_heard = is_heard || (listens != nullptr && listens->flow == on_host);
    }
    return is_heard;
  }));
  link->deliver(on_host, again);
  ASSERT_TRUE(eventually([&] { return !there.all().empty(); }));
  EXPECT_EQ(there.all().front().source, 4711U);
  EXPECT_EQ(there.all().front().sequence, 12U);
  EXPECT_EQ(there.all().front().sent_wall_ns, 1000);
}

TEST_F(LinkBusTest, EveryPacketBearsItsMarkAndNoneIsAbove1400Bytes) {
  RtpsCapture capture;
  if (!capture.ok()) GTEST_SKIP() << "no packet socket: CAP_NET_RAW is needed";
  Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto writer = vehicle->advertise(endpoint<topic::CameraImage>());
  const auto image = std::make_shared<topic::CameraImage::Message>();
  image->data().resize(10000);
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(image);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return gcs.crossed().size() > 3;
  }));
  const int port = 7400 + 250 * options(Role::uxv).link_domain;
  std::size_t pieces = 0;
  std::size_t on_host = 0;
  for (const CapturedSubmessage& one : capture.take()) {
    if (one.port < port || one.port >= port + 250) {
      on_host += one.statistics ? 1 : 0;
      continue;
    }
    EXPECT_LE(one.packet_bytes, 1428U);
    EXPECT_FALSE(one.statistics) << static_cast<int>(one.kind);
    EXPECT_EQ(one.dscp, one.builtin() ? 48 : relay_dscp);
    pieces += one.kind == 0x15 && one.packet_bytes > 1000 ? 1 : 0;
    EXPECT_NE(one.kind == 0x07 && !one.builtin(), true) << "a heartbeat";
  }
  EXPECT_GT(pieces, 7U);
  EXPECT_GT(on_host, 0U) << "the host's packets have statistics, so that they would be seen here";
  const LinkPackets packets = uxv.packets();
  EXPECT_GT(packets.discovery_packets, 0U);
  EXPECT_GT(packets.bytes, packets.discovery_bytes);
}

}  // namespace
}  // namespace tocsin
