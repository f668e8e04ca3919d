// SPDX-License-Identifier: Apache-2.0
#include "link/flow_table.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using namespace link_event;

class FlowTableTest : public ::testing::Test {
 protected:
  static FlowTable::Guid guid(std::uint8_t participant, std::uint8_t entity) {
    FlowTable::Guid guid;
    guid.guidPrefix.value[3] = participant;
    guid.entityId.value[1] = entity;
    return guid;
  }
  static AnnouncedEnd writer(const std::string& topic, const std::string& user_data = "") {
    AnnouncedEnd end;
    end.topic = topic;
    end.type = "Type";
    end.writer = true;
    end.user_data = user_data;
    return end;
  }
  template <class Event>
  Event next() {
    const auto event = sut_.pop();
    if (!event || !std::holds_alternative<Event>(*event)) {
      ADD_FAILURE() << "another event, or none";
      return {};
    }
    return std::get<Event>(*event);
  }

  int woken_ = 0;
  Time now_{std::chrono::hours(1)};
  TrafficRules rules_{std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml", Role::uxv};
  FlowTable sut_{"", rules_, [this] { ++woken_; }};
};

TEST_F(FlowTableTest, WritersOfAHostThatAnnounceTheSameAreOneFlow) {
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat"), true);
  sut_.on_host_end(guid(2, 1), writer("rt/heartbeat"), true);
  const auto flow = next<HostFlow>();
  EXPECT_EQ(flow.what.topic, "heartbeat");
  EXPECT_FALSE(sut_.pop());
  EXPECT_EQ(sut_.flow_of(guid(1, 1)), flow.flow);
  EXPECT_EQ(sut_.flow_of(guid(2, 1)), flow.flow);
  EXPECT_GE(woken_, 1);
}

TEST_F(FlowTableTest, AFlowEndsWithItsLastWriter) {
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat"), true);
  sut_.on_host_end(guid(2, 1), writer("rt/heartbeat"), true);
  const auto flow = next<HostFlow>();
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat"), false);
  EXPECT_FALSE(sut_.pop());
  sut_.on_host_end(guid(2, 1), writer("rt/heartbeat"), false);
  EXPECT_EQ(next<HostFlowGone>().flow, flow.flow);
  EXPECT_FALSE(sut_.find(flow.flow));
}

TEST_F(FlowTableTest, WritersThatAnnounceSomethingElseAreAFlowOfTheirOwn) {
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat"), true);
  sut_.on_host_end(guid(1, 2), writer("rt/heartbeat", "speaker=station;"), true);
  const auto one = next<HostFlow>();
  const auto other = next<HostFlow>();
  EXPECT_NE(one.flow, other.flow);
  EXPECT_EQ(other.what.user_data, "speaker=station;");
}

TEST_F(FlowTableTest, TheNamespaceOfAHostIsNotOnTheLink) {
  FlowTable sut("uxv3", rules_, [] {});
  sut.on_host_end(guid(1, 1), writer("rt/uxv3/heartbeat"), true);
  sut.on_host_end(guid(1, 2), writer("rt/uxv4/heartbeat"), true);
  sut.on_link_end(guid(2, 1), writer("rt/goal"), true);
  sut.on_link_end(guid(2, 2), writer("rt/uxv3/goal"), true);
  EXPECT_EQ(std::get<HostFlow>(*sut.pop()).what.topic, "heartbeat");
  EXPECT_EQ(std::get<PeerFlow>(*sut.pop()).what.topic, "goal");
  EXPECT_FALSE(sut.pop());
}

TEST_F(FlowTableTest, WhatTheTrafficFileDoesNotNameStays) {
  sut_.on_host_end(guid(1, 1), writer("rt/odom"), true);
  sut_.on_host_end(guid(1, 2), writer("ros_discovery_info"), true);
  AnnouncedEnd reader = writer("rt/heartbeat");
  reader.writer = false;
  sut_.on_host_end(guid(1, 3), reader, true);
  EXPECT_FALSE(sut_.pop());
}

TEST_F(FlowTableTest, AWriterThatAnnouncesItselfAgainChangesNothing) {
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat"), true);
  (void)next<HostFlow>();
  sut_.on_host_end(guid(1, 1), writer("rt/heartbeat", "new=1;"), true);
  EXPECT_FALSE(sut_.pop());
}

TEST_F(FlowTableTest, EachWriterOfAPeerIsAFlowWithWhatItSays) {
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal", "tocsinflow=reliable,volatile,2,5;"), true);
  EXPECT_EQ(next<PeerFound>().name, "gcs");
  const auto flow = next<PeerFlow>();
  EXPECT_EQ(flow.peer, FlowTable::peer_of(guid(9, 0).guidPrefix));
  EXPECT_EQ(flow.wire_id, 0x00040000U);
  EXPECT_TRUE(flow.what.reliable);
  EXPECT_EQ(flow.what.depth, 2);
  EXPECT_EQ(flow.what.user_data, "");
}

TEST_F(FlowTableTest, APeerThatLeavesTakesItsFlowsAlong) {
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal"), true);
  (void)next<PeerFound>();
  const auto flow = next<PeerFlow>();
  sut_.on_peer(guid(9, 0).guidPrefix, "", false, now_);
  EXPECT_EQ(next<PeerFlowGone>().flow, flow.flow);
  EXPECT_EQ(next<PeerLost>().peer, flow.peer);
}

TEST_F(FlowTableTest, ARestartedPeerTakesOverWhenItIsReceivedFromAndTheFormerIsNot) {
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal"), true);
  (void)next<PeerFound>();
  const auto flow = next<PeerFlow>();
  EXPECT_TRUE(sut_.on_received(guid(9, 4), now_));
  sut_.on_peer(guid(10, 0).guidPrefix, "gcs", true, now_);
  sut_.on_link_end(guid(10, 4), writer("rt/goal"), true);
  sut_.on_peer_listens(guid(10, 0).guidPrefix, 3, true);
  sut_.on_peer_listens(guid(10, 0).guidPrefix, 4, true);
  sut_.on_peer_listens(guid(10, 0).guidPrefix, 4, false);
  const auto held = next<PeerFlow>();
  EXPECT_EQ(held.flow, sut_.flow_of(guid(10, 4))) << "it is received, and its peer is not reported";
  (void)next<PeerReaderMatched>();
  (void)next<PeerReaderMatched>();
  EXPECT_EQ(next<PeerReaderGone>().flow, 4U);
  now_ += PeerInstances::least_silence;
  EXPECT_TRUE(sut_.on_received(guid(10, 4), now_));
  EXPECT_EQ(next<PeerFound>().peer, held.peer);
  EXPECT_EQ(next<PeerFlowGone>().flow, flow.flow);
  EXPECT_EQ(next<PeerLost>().peer, flow.peer);
  EXPECT_EQ(next<PeerFlow>().peer, flow.peer) << "it may return";
  EXPECT_EQ(next<PeerFlow>().flow, held.flow);
  EXPECT_EQ(next<PeerReaderMatched>().flow, 3U) << "the one that is still read";
  sut_.on_peer(guid(9, 0).guidPrefix, "", false, now_);  // its lease ends at last
  (void)next<PeerFlowGone>();
  EXPECT_FALSE(sut_.pop());
}

TEST_F(FlowTableTest, AnAnnouncerOfTheSameNameDoesNotEndAPeerThatGoesOn) {
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal"), true);
  (void)next<PeerFound>();
  const auto flow = next<PeerFlow>();
  sut_.on_peer(guid(10, 0).guidPrefix, "gcs", true, now_);
  for (int i = 0; i < 100; ++i, now_ += std::chrono::milliseconds(100)) {
    EXPECT_TRUE(sut_.on_received(guid(9, 4), now_));
    EXPECT_FALSE(sut_.on_received(guid(10, 4), now_));
  }
  EXPECT_FALSE(sut_.pop());
  EXPECT_EQ(sut_.flow_of(guid(9, 4)), flow.flow);
}

TEST_F(FlowTableTest, ASecondPeerIsNoNextLife) {
  sut_.on_peer(guid(9, 0).guidPrefix, "gcs", true, now_);
  sut_.on_peer(guid(10, 0).guidPrefix, "other", true, now_);
  EXPECT_EQ(next<PeerFound>().name, "gcs");
  EXPECT_EQ(next<PeerFound>().name, "other");
  EXPECT_FALSE(sut_.pop());
}

TEST_F(FlowTableTest, SamplesBeyondItsRoomAreLostAndNothingElseIs) {
  for (int i = 0; i < 5000; ++i) sut_.push(HostSample{1, {}, {}});
  sut_.push(HostFlowGone{7});
  int samples = 0;
  bool gone = false;
  while (const auto event = sut_.pop()) {
    samples += std::holds_alternative<HostSample>(*event) ? 1 : 0;
    gone = std::holds_alternative<HostFlowGone>(*event);
  }
  EXPECT_EQ(samples, 4096);
  EXPECT_TRUE(gone);
}

TEST(TopicNames, AreThoseOfTheirNamespaceOnly) {
  const TopicNames plain("");
  EXPECT_EQ(plain.on_wire("odom"), "rt/odom");
  EXPECT_EQ(plain.of_people("rt/odom"), "odom");
  EXPECT_FALSE(plain.of_people("rq/service"));
  const TopicNames robot("robot1");
  EXPECT_EQ(robot.on_wire("odom"), "rt/robot1/odom");
  EXPECT_EQ(robot.of_people("rt/robot1/odom"), "odom");
  EXPECT_FALSE(robot.of_people("rt/robot2/odom"));
  EXPECT_FALSE(robot.of_people("rt/robot1"));
}

TEST_F(FlowTableTest, AnAbsentPeerIsLostUntilItIsWantedAgain) {
  sut_.on_peer(guid(9, 0).guidPrefix, "north", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal"), true);
  sut_.on_peer_listens(guid(9, 0).guidPrefix, 3, true);
  (void)next<PeerFound>();
  const auto flow = next<PeerFlow>();
  (void)next<PeerReaderMatched>();
  EXPECT_TRUE(sut_.on_received(guid(9, 4), now_));
  sut_.set_absent({"north"});
  EXPECT_EQ(next<PeerFlowGone>().flow, flow.flow);
  EXPECT_EQ(next<PeerLost>().peer, flow.peer);
  const auto held = next<PeerFlow>();
  EXPECT_FALSE(sut_.pop());
  EXPECT_FALSE(sut_.on_received(guid(9, 4), now_));
  EXPECT_TRUE(sut_.take_superseded().empty()) << "discovery must not forget it";
  sut_.set_absent({});
  EXPECT_EQ(next<PeerFound>().name, "north");
  EXPECT_EQ(next<PeerFlow>().flow, held.flow);
  EXPECT_EQ(next<PeerReaderMatched>().flow, 3U);
  EXPECT_TRUE(sut_.on_received(guid(9, 4), now_));
}

TEST_F(FlowTableTest, APeerThatComesWhileItIsAbsentIsFoundWhenItIsWanted) {
  sut_.set_absent({"north"});
  sut_.on_peer(guid(9, 0).guidPrefix, "north", true, now_);
  sut_.on_link_end(guid(9, 4), writer("rt/goal"), true);
  const auto held = next<PeerFlow>();
  EXPECT_FALSE(sut_.pop());
  sut_.set_absent({"south"});
  EXPECT_EQ(next<PeerFound>().name, "north");
  EXPECT_EQ(next<PeerFlow>().flow, held.flow);
}

}  // namespace
}  // namespace tocsin
