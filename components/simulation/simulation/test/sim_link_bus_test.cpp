// SPDX-License-Identifier: Apache-2.0
// How routers of simulated hosts find each other, and what of each other's flows they know.
#include "sim_link_bus.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

using link_event::HostFlow;
using link_event::HostFlowGone;
using link_event::HostSample;
using link_event::PeerFlow;
using link_event::PeerFlowGone;
using link_event::PeerFound;
using link_event::PeerLost;
using link_event::PeerReaderGone;
using link_event::PeerReaderMatched;

TEST_F(LinkBusTest, RoutersFindEachOtherATenthOfASecondAfterTheLaterOneIsMade) {
  start(uxv_);
  run_for(5);
  start(gcs_);
  run_for(0.099);
  EXPECT_EQ(up().count<PeerFound>(), 0U);
  EXPECT_EQ(down().count<PeerFound>(), 0U);
  run_for(0.001);
  ASSERT_EQ(up().count<PeerFound>(), 1U);
  ASSERT_EQ(down().count<PeerFound>(), 1U);
  EXPECT_EQ(up().got<PeerFound>()[0].name, "gcs");
  EXPECT_EQ(up().got<PeerFound>()[0].peer, down().bus.self());
  EXPECT_EQ(down().got<PeerFound>()[0].name, "uxv");
  EXPECT_EQ(down().got<PeerFound>()[0].peer, up().bus.self());
}

TEST_F(LinkBusTest, ARouterThatDiesBeforeItIsFoundIsNotFound) {
  start(uxv_);
  start(gcs_);
  kill_router(gcs_);
  run_for(1);
  EXPECT_EQ(up().count<PeerFound>(), 0U);
}

TEST_F(LinkBusTest, EachEventWakesTheRouterOnce) {
  connect();
  write<topic::Location>(drive_);
  run_for(1);
  EXPECT_EQ(up().wake_ups, static_cast<int>(up().events.size()));
  EXPECT_EQ(down().wake_ups, static_cast<int>(down().events.size()));
  EXPECT_FALSE(up().bus.take());
}

TEST_F(LinkBusTest, AFlowIsWhatItsWriterAnnounces) {
  connect();
  write<topic::CameraImage>(payload_);
  run_for(1);
  ASSERT_EQ(down().count<PeerFlow>(), 1U);
  const PeerFlow flow = down().got<PeerFlow>()[0];
  EXPECT_EQ(flow.peer, up().bus.self());
  EXPECT_EQ(flow.wire_id, up().bus.wire_id(up().opened.begin()->second, 0));
  EXPECT_EQ(flow.what, up().got<HostFlow>()[0].what);
  EXPECT_EQ(flow.what.topic, "camera/image_raw/compressed");
  EXPECT_EQ(flow.what.type, "sensor_msgs::msg::dds_::CompressedImage_");
  EXPECT_TRUE(flow.what.reliable);
  EXPECT_FALSE(flow.what.transient_local);
  EXPECT_EQ(flow.what.depth, 1);
  EXPECT_EQ(flow.what.lifespan_s, 1);
  write<topic::TransmissionState>(drive_);
  run_for(1);
  ASSERT_EQ(down().count<PeerFlow>(), 2U);
  const Flow state = down().got<PeerFlow>()[1].what;
  EXPECT_TRUE(state.reliable);
  EXPECT_TRUE(state.transient_local);
  EXPECT_TRUE(std::isinf(state.lifespan_s));
}

TEST_F(LinkBusTest, ThePeersReaderMatchesATenthOfASecondAfterAFlowIsOpened) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(0.099);
  EXPECT_EQ(down().count<PeerFlow>(), 0U);
  run_for(0.001);
  EXPECT_EQ(down().count<PeerFlow>(), 1U);
  ASSERT_EQ(up().count<PeerReaderMatched>(), 1U);
  EXPECT_EQ(up().got<PeerReaderMatched>()[0].flow, up().opened.begin()->second);
  EXPECT_EQ(up().got<PeerReaderMatched>()[0].peer, down().bus.self());
}

TEST_F(LinkBusTest, OfAFlowOnDemandThePeersReaderMatchesWhileAComponentThereReads) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Scan>());
  run_for(1);
  EXPECT_EQ(down().count<PeerFlow>(), 1U);
  EXPECT_EQ(up().count<PeerReaderMatched>(), 0U);
  Reader reader;
  auto subscription = view_.subscribe(endpoint<topic::Scan>(), reader);
  run_for(0.1);
  EXPECT_EQ(up().count<PeerReaderMatched>(), 1U);
  Reader other;
  const auto second = view_.subscribe(endpoint<topic::Scan>(), other);
  subscription.reset();
  run_for(0.1);
  EXPECT_EQ(up().count<PeerReaderMatched>(), 1U);
  EXPECT_EQ(up().count<PeerReaderGone>(), 0U) << "the other still reads";
}

TEST_F(LinkBusTest, SamplesOnDemandReachTheRouterWhileItWantsThem) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Scan>());
  const auto write = [&] {
    EXPECT_EQ(writer->write(message<topic::Scan>()), Status::ok);
    run_for(0.1);
    return up().numbers.size();
  };
  EXPECT_EQ(write(), 0U);
  const FlowId flow = up().got<HostFlow>()[0].flow;
  up().bus.want(flow, true);
  EXPECT_EQ(write(), 1U);
  up().bus.want(flow, false);
  EXPECT_EQ(write(), 1U);
}

TEST_F(LinkBusTest, AStateOnDemandReachesTheRouterWhenItIsWanted) {
  connect();
  write<topic::TfStatic>(drive_);
  run_for(0.1);
  EXPECT_TRUE(up().numbers.empty());
  up().bus.want(up().got<HostFlow>()[0].flow, true);
  run_for(0.1);
  EXPECT_EQ(up().numbers.size(), 1U);
}

TEST_F(LinkBusTest, OfAFlowOnDemandThePeersReaderGoesWithTheLastComponentThatReads) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Scan>());
  Reader reader;
  auto subscription = view_.subscribe(endpoint<topic::Scan>(), reader);
  run_for(1);
  ASSERT_EQ(up().count<PeerReaderMatched>(), 1U) << "it was there first";
  subscription.reset();
  run_for(0.1);
  ASSERT_EQ(up().count<PeerReaderGone>(), 1U);
  EXPECT_EQ(up().got<PeerReaderGone>()[0].peer, down().bus.self());
}

TEST_F(LinkBusTest, AFlowThatIsClosedBeforeThePeerHearsOfItIsUnknownToIt) {
  connect();
  const FlowId flow = up().bus.open({}, TrafficClass::critical);
  up().bus.close(flow);
  run_for(1);
  EXPECT_EQ(down().count<PeerFlow>(), 0U);
  EXPECT_EQ(down().count<PeerFlowGone>(), 0U);
}

TEST_F(LinkBusTest, ADeadRouterIsNotMissedUntilItsSuccessorComes) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  const PeerId first = up().bus.self();
  const FlowId flow = down().got<PeerFlow>()[0].flow;
  kill_router(uxv_);
  run_for(30);
  EXPECT_EQ(down().count<PeerLost>(), 0U);
  EXPECT_EQ(down().count<PeerFlowGone>(), 0U);
  start(uxv_);
  run_for(1);
  ASSERT_EQ(down().count<PeerFound>(), 2U);
  EXPECT_EQ(down().got<PeerFound>()[1].peer, up().bus.self());
  ASSERT_EQ(down().count<PeerLost>(), 1U);
  EXPECT_EQ(down().got<PeerLost>()[0].peer, first);
  ASSERT_EQ(down().count<PeerFlowGone>(), 1U);
  EXPECT_EQ(down().got<PeerFlowGone>()[0].flow, flow);
  ASSERT_EQ(down().count<PeerFlow>(), 2U);
  EXPECT_EQ(down().got<PeerFlow>()[1].peer, up().bus.self());
  EXPECT_NE(down().got<PeerFlow>()[1].flow, flow);
}

TEST_F(LinkBusTest, CrossingGoesOnWithTheSuccessorOfEitherRouter) {
  connect();
  Reader& away = read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  for (SimHost* host : {&uxv_, &gcs_}) {
    kill_router(*host);
    run_for(1);
    (void)writer->write(message<topic::Location>());
    run_for(1);
    start(*host);
    run_for(0.2);
    (void)writer->write(message<topic::Location>());
    run_for(1);
  }
  ASSERT_EQ(away.samples.size(), 2U);
  EXPECT_EQ(away.samples[0].sequence, 2U);
  EXPECT_EQ(away.samples[1].sequence, 4U);
}

TEST_F(LinkBusTest, OnlyWhatIsOnTheAirToALivingRouterArrives) {
  for (SimHost* dead : {&uxv_, &gcs_}) {
    connect();
    Reader& away = read<topic::Location>(mission_);
    const auto writer = drive_.advertise(endpoint<topic::Location>());
    run_for(1);
    (void)writer->write(message<topic::Location>());
    up().work();
    kill_router(*dead);
    if (dead == &gcs_) start(gcs_);
    run_for(1);
    EXPECT_EQ(away.samples.size(), dead == &uxv_ ? 1U : 0U);
  }
}

TEST_F(LinkBusTest, FlowsOfOneTopicWithDifferentUserDataAreTwoAndNameTheirWriters) {
  connect();
  Reader away;
  const auto subscription = drive_.subscribe(endpoint<topic::MissionStatus>(), away);
  const char* station = "tocsinstop=station;";
  const auto one = mission_.advertise(endpoint<topic::MissionStatus>(station));
  const auto other = view_.advertise(endpoint<topic::MissionStatus>());
  run_for(1);
  ASSERT_EQ(up().count<PeerFlow>(), 2U);
  EXPECT_EQ(up().got<PeerFlow>()[0].what.user_data, station);
  EXPECT_EQ(up().got<PeerFlow>()[1].what.user_data, "");
  EXPECT_NE(up().got<PeerFlow>()[0].wire_id, up().got<PeerFlow>()[1].wire_id);
  (void)one->write(message<topic::MissionStatus>());
  (void)other->write(message<topic::MissionStatus>());
  run_for(1);
  ASSERT_EQ(away.samples.size(), 2U);
  EXPECT_NE(away.samples[0].source, away.samples[1].source);
  const auto info = subscription->writer(away.samples[0].source);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->name, "gcs");
  EXPECT_EQ(info->user_data, station);
  EXPECT_FALSE(subscription->writer(999));
}

TEST_F(LinkBusTest, WritersThatAnnounceTheSameAreOneFlowUntilTheLastIsGone) {
  connect();
  Reader& away = read<topic::Heartbeat>(mission_);
  auto one = drive_.advertise(endpoint<topic::Heartbeat>());
  auto other = payload_.advertise(endpoint<topic::Heartbeat>());
  run_for(1);
  EXPECT_EQ(down().count<PeerFlow>(), 1U);
  (void)one->write(message<topic::Heartbeat>());
  (void)other->write(message<topic::Heartbeat>());
  run_for(1);
  EXPECT_EQ(away.samples.size(), 2U);
  one.reset();
  drive_.die();
  run_for(1);
  EXPECT_EQ(up().count<HostFlowGone>(), 0U);
  other.reset();
  payload_.die();
  run_for(1);
  EXPECT_EQ(up().count<HostFlowGone>(), 1U);
  ASSERT_EQ(down().count<PeerFlowGone>(), 1U);
  EXPECT_EQ(down().got<PeerFlowGone>()[0].flow, down().got<PeerFlow>()[0].flow);
}

TEST_F(LinkBusTest, NothingOfAClosedFlowIsSentOrGiven) {
  connect();
  Reader& away = read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  (void)writer->write(message<topic::Location>());
  up().work();
  const FlowId flow = up().opened.begin()->second;
  up().bus.close(flow);  // while the sample is on the air
  run_for(1);
  EXPECT_EQ(down().count<PeerFlowGone>(), 1U);
  EXPECT_TRUE(away.samples.empty());
  for (const FlowId gone : {flow, FlowId{999}}) {
    EXPECT_EQ(up().bus.send(gone, up().got<HostSample>()[0].sample, {}, 0), std::nullopt);
  }
}

TEST_F(LinkBusTest, AProcessOpensTheLinkOfItsHost) {
  int told = 0;
  const auto sut = drive_.link_access()->open_link([&told] { ++told; });
  write<topic::Location>(payload_);
  EXPECT_EQ(uxv_.router(), sut.get());
  EXPECT_EQ(&sut->rules(), &uxv_.rules());
  EXPECT_EQ(told, 2);  // the flow and the sample
}

}  // namespace
}  // namespace tocsin::simulation
