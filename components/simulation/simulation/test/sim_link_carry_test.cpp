// SPDX-License-Identifier: Apache-2.0
// What routers of simulated hosts carry, and to whom.
#include <gtest/gtest.h>

#include "link_bus_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin::simulation {
namespace {

using link_event::HostFlow;
using link_event::HostSample;
using link_event::LinkSample;
using link_event::PeerFlow;
using link_event::PeerFound;
using link_event::PeerReaderMatched;

TEST_F(LinkBusTest, ASampleReachesEveryProcessOfTheOtherHostOnce) {
  connect();
  Reader& first = read<topic::Location>(mission_);
  Reader& second = read<topic::Location>(view_);
  Reader& third = read<topic::Location>(view_);
  Reader& near = read<topic::Location>(payload_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  (void)writer->write(message<topic::Location>());
  EXPECT_TRUE(first.samples.empty());
  EXPECT_EQ(near.samples.size(), 1U) << "at once on the writer's host";
  run_for(1);
  for (const Reader* one : {&first, &second, &third, &near}) EXPECT_EQ(one->samples.size(), 1U);
  EXPECT_EQ(down().count<LinkSample>(), 1U);  // however many read it
}

TEST_F(LinkBusTest, SourceSequenceSendTimeAndTheMessageItselfCross) {
  connect();
  Reader& near = read<topic::Location>(payload_);
  Reader& away = read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  (void)writer->write(message<topic::Location>());
  run_for(1);
  const Time sent = core_.now;
  const auto written = message<topic::Location>();
  (void)writer->write(written);
  run_for(1);
  ASSERT_EQ(near.samples.size(), 2U);
  ASSERT_EQ(away.samples.size(), 2U);
  const Sample& got = away.samples[1];
  EXPECT_EQ(got.message, written);
  EXPECT_EQ(got.source, near.samples[1].source);
  EXPECT_EQ(got.sequence, 2U);
  EXPECT_EQ(got.sent_wall_ns, Core::wall_ns(sent));
  EXPECT_EQ(got.bytes, type_info<topic::Location::Message>().serialized_size(written.get()));
  EXPECT_EQ(got.received, sent + seconds(0.01));  // as long as the radio takes
  EXPECT_EQ(got.received_wall_ns, Core::wall_ns(got.received));
}

TEST_F(LinkBusTest, ACompressedSampleTakesTheBytesThatItWouldTakeForReal) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::LinkState>());
  run_for(1);
  (void)writer->write(message<topic::LinkState>());
  (void)writer->write(message<topic::LinkState>());
  run_for(1);
  const auto taken = up().got<HostSample>();
  ASSERT_EQ(taken.size(), 2U);
  const auto alone = up().bus.compress(taken[0].sample, nullptr);
  const auto based = up().bus.compress(taken[1].sample, &taken[0].sample);
  ASSERT_TRUE(alone && based);
  EXPECT_LT(alone->bytes, taken[0].sample.bytes / 2);
  EXPECT_LT(based->bytes, alone->bytes);
  EXPECT_EQ(based->coding, (SampleCoding{true, 1}));
  const auto plain = up().bus.restore(*based, &taken[0].sample);
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->bytes, taken[1].sample.bytes);
  EXPECT_EQ(plain->content, taken[1].sample.content);
}

TEST_F(LinkBusTest, EachHostTellsTheTimeByItsOwnClock) {
  connect();
  uxv_.jump(seconds(100));
  gcs_.jump(seconds(-7));
  Reader& away = read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  (void)writer->write(message<topic::Location>());
  run_for(1);
  ASSERT_EQ(away.samples.size(), 1U);
  EXPECT_EQ(away.samples[0].sent_wall_ns - away.samples[0].received_wall_ns,
            (seconds(107) - seconds(0.01)).count());
}

TEST_F(LinkBusTest, ASampleThatIsSentAgainIsGivenOnce) {
  connect();
  Reader& away = read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  (void)writer->write(message<topic::Location>());
  run_for(1);
  const FlowId flow = up().opened.begin()->second;
  EXPECT_EQ(up().bus.send(flow, up().got<HostSample>()[0].sample, {}, 0), 2U);
  run_for(1);
  EXPECT_EQ(down().count<LinkSample>(), 2U);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(LinkBusTest, TransmissionsOfEachFlowAreNumberedFromOne) {
  connect();
  const auto location = drive_.advertise(endpoint<topic::Location>());
  const auto heartbeat = drive_.advertise(endpoint<topic::Heartbeat>());
  run_for(1);
  for (int i = 0; i < 3; ++i) (void)location->write(message<topic::Location>());
  (void)heartbeat->write(message<topic::Heartbeat>());
  run_for(1);
  EXPECT_EQ(up().numbers, (std::vector<std::uint64_t>{1, 2, 3, 1}));
  std::vector<std::uint64_t> came;
  for (const LinkSample& one : down().got<LinkSample>()) came.push_back(one.number);
  EXPECT_EQ(came, up().numbers);
}

TEST_F(LinkBusTest, AStateThatADeadRouterCarriedIsLostForLateReadersUntilItIsCarriedAgain) {
  connect();
  const auto writer = drive_.advertise(endpoint<topic::TransmissionState>());
  (void)read<topic::TransmissionState>(mission_);
  run_for(1);
  (void)writer->write(message<topic::TransmissionState>());
  run_for(1);
  kill_router(gcs_);
  Reader& late = read<topic::TransmissionState>(view_);
  EXPECT_TRUE(late.samples.empty());
  start(gcs_);
  run_for(1);
  EXPECT_EQ(late.samples.size(), 1U);
}

TEST_F(LinkBusTest, WhatTheAirLosesIsNotRepairedByTheBus) {
  connect();
  Reader& away = read<topic::TransmissionState>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::TransmissionState>());
  run_until(start_time + seconds(101));
  (void)writer->write(message<topic::TransmissionState>());
  run_for(20);
  EXPECT_TRUE(away.samples.empty());
  (void)writer->write(message<topic::TransmissionState>());
  run_for(1);
  ASSERT_EQ(down().count<LinkSample>(), 1U);
  EXPECT_EQ(down().got<LinkSample>()[0].number, 2U);  // so that the loss can be told
}

TEST_F(LinkBusTest, ALateReaderGetsTheLastStateThatWasCarried) {
  connect();
  const auto state = drive_.advertise(endpoint<topic::TransmissionState>());
  const auto location = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  for (int i = 0; i < 3; ++i) (void)state->write(message<topic::TransmissionState>());
  (void)location->write(message<topic::Location>());
  run_for(1);
  const Reader& of_state = read<topic::TransmissionState>(mission_);
  ASSERT_EQ(of_state.samples.size(), 1U);
  EXPECT_EQ(of_state.samples[0].sequence, 3U);
  EXPECT_TRUE(read<topic::Location>(mission_).samples.empty());
}

TEST_F(LinkBusTest, ARouterThatIsMadeLaterLearnsOfWritersAndOfTheirLastStates) {
  Reader& of_state = read<topic::TransmissionState>(mission_);
  Reader& of_location = read<topic::Location>(mission_);
  write<topic::TransmissionState>(drive_, 3);
  write<topic::Location>(payload_);
  run_for(5);
  connect();
  EXPECT_EQ(up().count<HostFlow>(), 2U);
  ASSERT_EQ(up().count<HostSample>(), 1U);
  EXPECT_EQ(up().got<HostSample>()[0].sample.sequence, 3U);
  run_for(1);
  ASSERT_EQ(of_state.samples.size(), 1U);
  EXPECT_EQ(of_state.samples[0].sequence, 3U);
  EXPECT_TRUE(of_location.samples.empty());
}

TEST_F(LinkBusTest, ARestartedRouterRepeatsNothingToReadersThatHaveTheState) {
  connect();
  Reader& away = read<topic::TransmissionState>(mission_);
  write<topic::TransmissionState>(drive_);
  run_for(1);
  Reader& late = read<topic::TransmissionState>(view_);  // which has it from its host
  kill_router(uxv_);
  start(uxv_);
  run_for(1);
  EXPECT_EQ(down().count<LinkSample>(), 2U);
  EXPECT_EQ(away.samples.size(), 1U);
  EXPECT_EQ(late.samples.size(), 1U);
}

TEST_F(LinkBusTest, ARouterKnowsItsOwnHostsStateAlthoughThePeerHasWrittenTheSameTopic) {
  connect();
  const auto own = drive_.advertise(endpoint<topic::TransmissionState>());
  const auto other = mission_.advertise(endpoint<topic::TransmissionState>());
  run_for(1);
  (void)own->write(message<topic::TransmissionState>());
  run_for(1);
  (void)other->write(message<topic::TransmissionState>());
  run_for(1);
  kill_router(uxv_);
  start(uxv_);
  run_for(1);
  EXPECT_EQ(up().count<HostSample>(), 1U);
}

TEST_F(LinkBusTest, ALateReaderGetsTheLastStateOfEachWriter) {
  connect();
  const auto own = drive_.advertise(endpoint<topic::TransmissionState>());
  const auto other = mission_.advertise(endpoint<topic::TransmissionState>());
  run_for(1);
  (void)own->write(message<topic::TransmissionState>());
  (void)other->write(message<topic::TransmissionState>());
  run_for(1);
  EXPECT_EQ(read<topic::TransmissionState>(payload_).samples.size(), 2U);
}

TEST_F(LinkBusTest, ALateReaderGetsNothingOfAWriterOnItsHostThatHasDied) {
  connect();
  {
    const auto own = drive_.advertise(endpoint<topic::TransmissionState>());
    (void)own->write(message<topic::TransmissionState>());
    run_for(1);
  }
  drive_.die();
  EXPECT_TRUE(read<topic::TransmissionState>(payload_).samples.empty());
  EXPECT_EQ(read<topic::TransmissionState>(mission_).samples.size(), 1U);  // its router has it
}

TEST_F(LinkBusTest, EveryPeerGetsACopy) {
  SimProcess& screen = tablet_.add_process("screen");
  connect();
  start(tablet_);
  Reader& first_reader = read<topic::Location>(mission_);
  Reader& second_reader = read<topic::Location>(screen);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(0.5);
  EXPECT_EQ(up().count<PeerFound>(), 2U);
  EXPECT_EQ(up().count<PeerReaderMatched>(), 2U);
  (void)writer->write(message<topic::Location>());
  run_for(0.1);
  EXPECT_EQ(first_reader.samples.size(), 1U);
  EXPECT_EQ(second_reader.samples.size(), 1U);
  EXPECT_EQ(up().bus.packets().packets, 2U);
}

}  // namespace
}  // namespace tocsin::simulation
