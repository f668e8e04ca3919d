// SPDX-License-Identifier: Apache-2.0
// The router on a scripted link, in virtual time.
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "link_router_fixture.hpp"

namespace tocsin {
namespace {

TEST_F(LinkRouterTest, ASampleOfTheHostGoesOnTheLinkAsItIs) {
  const FlowId on_link = begin("heartbeat");
  write(5);
  ASSERT_EQ(script_.sent_on(on_link), 1U);
  const CarriedSample& sample = script_.sent.back().sample;
  EXPECT_EQ(sample.source, 9U);
  EXPECT_EQ(sample.sequence, 5U);
  EXPECT_EQ(sample.bytes, 100U);
  EXPECT_EQ(*static_cast<const int*>(sample.content.get()), 5);
}

TEST_F(LinkRouterTest, AClassLimitsRateLifespanAndDepthOfAForeignTopic) {
  const TemporaryFolder folder;
  script_.rules = TrafficRules(
      folder.write("traffic.yaml",
                   "uxv: {low: {topics: ['*'], max_rate_hz: 10, lifespan_s: 0.5, depth: 10}}\n"),
      Role::uxv);
  const FlowId on_link = begin("robot/points");
  EXPECT_EQ(script_.opened.at(on_link).flow.depth, 10);
  EXPECT_EQ(script_.opened.at(on_link).flow.lifespan_s, 0.5);
  for (std::uint64_t i = 1; i <= 100; ++i) {
    write(i);
    run(0.01);
  }
  EXPECT_NEAR(static_cast<double>(script_.sent_on(on_link)), 10, 1);
}

TEST_F(LinkRouterTest, TransformsCrossAsOneMessageEachInterval) {
  using Transforms = tf2_msgs::msg::TFMessage;
  const TemporaryFolder folder;
  script_.rules = TrafficRules(
      folder.write("traffic.yaml", "uxv: {high: {topics: ['*'], max_rate_hz: 10, depth: 10}}\n"),
      Role::uxv);
  Flow tf = flow("tf");
  tf.type = type_info<Transforms>().name;
  script_.happen(link_event::HostFlow{host_flow, tf});
  run(0);
  const FlowId on_link = script_.opened_for("tf");
  for (int i = 0; i < 50; ++i) {
    for (const char* frame : {"base", "arm", "hand"}) {
      auto message = std::make_shared<Transforms>();
      message->transforms().emplace_back().child_frame_id(frame);
      CarriedSample sample;
      sample.content = message;
      sample.source = 9;
      sample.sequence = static_cast<std::uint64_t>(3 * i + 1);
      sample.sent_wall_ns = host_->bus.wall_ns(host_->bus.now());
      script_.happen(link_event::HostSample{host_flow, sample, host_->bus.now()});
    }
    run(0.02);
  }
  run(0.2);
  const std::size_t sent = script_.sent_on(on_link);
  EXPECT_NEAR(static_cast<double>(sent), 11, 1);
  const CarriedSample& last = script_.sent.back().sample;
  const auto frames = static_cast<const Transforms*>(last.content.get())->transforms().size();
  EXPECT_EQ(frames, 3U) << "also when no message follows";
  EXPECT_EQ(last.sequence, sent);
  EXPECT_NE(last.source, 9U);
}

TEST_F(LinkRouterTest, ALargeSampleGoesInPiecesThatThePeersRouterPutsTogether) {
  const FlowId on_link = begin("heartbeat");
  write(1, host_flow, 2500);
  ASSERT_EQ(script_.sent_on(on_link), 3U);
  EXPECT_EQ(script_.sent.back().piece, (SamplePiece{2, 3}));
  meet();
  begin_peer_flow("goal");
  receive(1, 10, {1, 3});
  receive(2, 10, {0, 3});
  EXPECT_TRUE(script_.delivered.empty());
  receive(3, 10, {2, 3});
  ASSERT_EQ(script_.delivered.size(), 1U);
  EXPECT_EQ(script_.delivered[0].sample.bytes, 300U);
  EXPECT_EQ(script_.delivered[0].sample.sequence, 10U);
}

class TwoPathRouterTest : public LinkRouterTest {
 protected:
  static constexpr FlowId second_flow = 700;
  TwoPathRouterTest() {
    script_.paths = 2;
    start({}, this_computer());
    meet();
  }
  void begin_second(const std::string& topic) { begin_peer_flow(topic, second_flow, 1); }
  /// Acknowledgements that were sent, by path.
  [[nodiscard]] std::array<int, 2> acknowledged() const {
    std::array<int, 2> count{};
    for (const auto& one : script_.sent) {
      if (script_.opened.at(one.flow).flow.topic == "link_acknowledgement") ++count[one.path];
    }
    return count;
  }
};

TEST_F(TwoPathRouterTest, ASampleIsDeliveredOnceWhicheverWayItComes) {
  begin_peer_flow("goal");
  begin_second("goal");
  EXPECT_EQ(script_.offered.size(), 1U) << "one writer for the host";
  receive_by(second_flow, 1, 10);
  receive_by(peer_flow, 1, 10);
  receive_by(peer_flow, 2, 11);
  receive_by(second_flow, 2, 11);
  ASSERT_EQ(script_.delivered.size(), 2U);
  EXPECT_EQ(script_.delivered[0].sample.sequence, 10U);
  EXPECT_EQ(script_.delivered[0].flow, peer_flow);
}

TEST_F(TwoPathRouterTest, PiecesOfBothPathsMakeOneSample) {
  begin_second("goal");
  begin_peer_flow("goal");
  receive_by(peer_flow, 1, 10, {0, 3});
  receive_by(second_flow, 1, 10, {1, 3});
  receive_by(peer_flow, 2, 10, {2, 3});
  ASSERT_EQ(script_.delivered.size(), 1U);
}

TEST_F(TwoPathRouterTest, AnAcknowledgementGoesBackByThePathsThatSomethingCameBy) {
  begin_peer_flow("goal");
  begin_second("goal");
  run(2);
  script_.sent.clear();
  receive_by(second_flow, 1, 10);
  run(0.1);
  EXPECT_EQ(acknowledged()[0], 0);
  EXPECT_EQ(acknowledged()[1], 1);
  const auto& message =
      *static_cast<const Acknowledgement*>(script_.sent.back().sample.content.get());
  EXPECT_EQ(message.streams(), std::vector<std::uint32_t>{second_flow + 1});
}

TEST_F(TwoPathRouterTest, AFlowOfTheSecondPathAloneWaitsForTheFirstAndOutlivesIt) {
  begin_second("goal");
  receive_by(second_flow, 1, 10);
  EXPECT_TRUE(script_.delivered.empty());
  begin_peer_flow("goal");
  receive_by(second_flow, 2, 11);
  EXPECT_EQ(script_.delivered.size(), 1U);
  script_.happen(link_event::PeerFlowGone{peer_flow});
  run(0);
  receive_by(second_flow, 3, 12);
  EXPECT_EQ(script_.delivered.size(), 1U);
  begin_peer_flow("goal", peer_flow + 10);
  receive_by(second_flow, 4, 13);
  EXPECT_EQ(script_.delivered.size(), 2U);
  script_.happen(link_event::PeerFlowGone{second_flow});
  run(0);
  receive_by(second_flow, 5, 14);
  EXPECT_EQ(script_.delivered.size(), 2U);
}

TEST_F(TwoPathRouterTest, FlowsThatAreToldOfAgainStayJoined) {
  begin_peer_flow("goal");
  begin_second("goal");
  begin_second("goal");
  begin_peer_flow("goal");
  receive_by(second_flow, 1, 10);
  ASSERT_EQ(script_.delivered.size(), 1U);
  EXPECT_EQ(script_.delivered[0].flow, peer_flow);
}

TEST_F(TwoPathRouterTest, ReportsBothPaths) {
  run(1.1);
  const auto state = host_->states.take().back();
  ASSERT_EQ(state.paths().size(), 2U);
  EXPECT_TRUE(state.paths()[0].chosen());
  EXPECT_EQ(state.paths()[0].bytes() + state.paths()[1].bytes(), state.bytes());
}

TEST_F(LinkRouterTest, ASampleOfACompressedTopicCrossesSmallerAndIsCountedAsBoth) {
  const TemporaryFolder folder;
  script_.rules = TrafficRules(
      folder.write("traffic.yaml", "uxv: {high: {topics: [odom], compress: [odom]}}\ngcs: {}\n"),
      Role::uxv);
  const FlowId on_link = begin("odom");
  meet();
  begin_peer_flow("link_acknowledgement", acknowledgement_flow);
  listen(on_link);
  write(1, host_flow, 600);
  EXPECT_EQ(script_.sent.back().sample.bytes, 150U);
  acknowledge(on_link, 1);
  write(2, host_flow, 600);
  EXPECT_EQ(script_.sent.back().sample.bytes, 60U);
  EXPECT_EQ(script_.sent.back().sample.coding, (SampleCoding{true, 1}));
  run(1);
  const auto traffic = host_->reports.take().back().topics()[0];
  EXPECT_EQ(traffic.plain_bytes() % 600, 0U);
  EXPECT_LT(traffic.sent_bytes(), traffic.plain_bytes() / 2);
}

TEST_F(LinkRouterTest, ACompressedSampleIsRestoredByItsBaseAndDeliveredOnce) {
  meet();
  begin_peer_flow("goal");
  receive(1, 10, {}, {true, 0});
  receive(2, 13, {}, {true, 3});
  receive(3, 13, {}, {true, 3});
  ASSERT_EQ(script_.delivered.size(), 2U);
  EXPECT_EQ(script_.delivered[1].sample.bytes, 1000U);
  EXPECT_FALSE(script_.delivered[1].sample.coding.is_compressed);
  EXPECT_EQ(script_.bases, (std::vector<std::uint64_t>{0, 10})) << "the third was there already";
}

TEST_F(LinkRouterTest, WhatCannotBeRestoredIsNeitherDeliveredNorAcknowledged) {
  meet();
  begin_peer_flow("goal");
  receive(1, 10, {}, {true, 0});
  receive(2, 15, {}, {true, 2});
  receive(3, 1, {}, {true, 200});
  script_.damaged = true;
  receive(4, 16, {}, {true, 6});
  EXPECT_EQ(script_.delivered.size(), 1U);
  run(0.2);
  const auto& acknowledgement =
      *static_cast<const Acknowledgement*>(script_.sent.back().sample.content.get());
  ASSERT_EQ(acknowledgement.streams().size(), 1U);
  EXPECT_EQ(acknowledgement.highest()[0], 1U);
  script_.damaged = false;
  receive(5, 17, {}, {true, 7});
  EXPECT_EQ(script_.delivered.size(), 2U) << "what came whole is a base";
}

TEST_F(LinkRouterTest, AFlowThatHasLeftIsClosed) {
  const FlowId on_link = begin("heartbeat");
  script_.happen(link_event::HostFlowGone{host_flow});
  run(0);
  EXPECT_TRUE(script_.opened.at(on_link).closed);
  write(1);
  EXPECT_EQ(script_.sent_on(on_link), 0U);
}

TEST_F(LinkRouterTest, AcknowledgesWhatWasReceived) {
  meet();
  begin_peer_flow("goal");
  receive(1, 10);
  run(0.2);
  const FlowId acknowledgements = script_.opened_for("link_acknowledgement");
  ASSERT_GE(script_.sent_on(acknowledgements), 1U);
  EXPECT_EQ(script_.opened.at(acknowledgements).traffic_class, TrafficClass::critical);
  const auto& acknowledgement =
      *static_cast<const Acknowledgement*>(script_.sent.back().sample.content.get());
  EXPECT_EQ(acknowledgement.from_instance(), ScriptedLink::own_instance);
  EXPECT_EQ(acknowledgement.to_instance(), station);
  ASSERT_EQ(acknowledgement.streams().size(), 1U);
  EXPECT_EQ(acknowledgement.streams()[0], peer_flow + 1);
  EXPECT_EQ(acknowledgement.highest()[0], 1U);
}

TEST_F(LinkRouterTest, WhatIsAcknowledgedIsNot) {
  meet();
  begin_peer_flow("link_acknowledgement", acknowledgement_flow);
  const FlowId on_link = begin("heartbeat");
  listen(on_link);
  write(1);
  run(0.05);
  acknowledge(on_link, 1);
  run(2);
  EXPECT_EQ(script_.sent_on(on_link), 1U);
}

TEST_F(LinkRouterTest, AnAcknowledgementForAnotherInstanceOrWithoutSenseIsIgnored) {
  meet();
  begin_peer_flow("link_acknowledgement", acknowledgement_flow);
  const FlowId on_link = begin("heartbeat");
  listen(on_link);
  write(1);
  auto other = std::make_shared<Acknowledgement>();
  other->to_instance(12);
  other->streams({1000 + on_link});
  other->highest({1});
  other->age_100us({0});
  other->before({0});
  tell(other);
  auto odd = std::make_shared<Acknowledgement>(*other);
  odd->to_instance(ScriptedLink::own_instance);
  odd->highest({});
  tell(odd);
  run(0.3);
  EXPECT_GE(script_.sent_on(on_link), 2U) << "it was taken for an acknowledgement";
}

TEST_F(LinkRouterTest, AnAcknowledgementOfAPeersFormerInstanceIsIgnored) {
  meet();
  begin_peer_flow("link_acknowledgement", acknowledgement_flow);
  const FlowId on_link = begin("heartbeat");
  meet(station + 1);
  script_.happen(link_event::PeerReaderMatched{on_link, station + 1});
  write(1);
  run(0.05);
  acknowledge(on_link, 1);
  run(0.3);
  EXPECT_GE(script_.sent_on(on_link), 2U) << "it was taken for the new instance's";
}

TEST_F(LinkRouterTest, SendsWhatIsOnDemandUntilThePeersReaderIsGone) {
  meet();
  const FlowId on_link = begin("scan");
  write(1);
  run(0.05);
  EXPECT_EQ(script_.sent_on(on_link), 0U);
  EXPECT_TRUE(script_.wanted.empty());
  listen(on_link);
  EXPECT_EQ(script_.wanted, std::set<FlowId>{host_flow});
  write(2);
  run(0.05);
  EXPECT_EQ(script_.sent_on(on_link), 1U);
  script_.happen(link_event::PeerReaderGone{on_link, station});
  write(3);
  run(0.05);
  EXPECT_EQ(script_.sent_on(on_link), 1U);
  EXPECT_TRUE(script_.wanted.empty());
}

TEST_F(LinkRouterTest, WhatALogNeedsIsTakenThoughNobodyReadsItAnyMore) {
  const TemporaryFolder folder;
  script_.rules = TrafficRules(
      folder.write("traffic.yaml", "uxv: {low: {topics: [scan], on_demand: [scan], log: [scan]}}"),
      Role::uxv);
  meet();
  const FlowId on_link = begin("scan");
  listen(on_link);
  script_.happen(link_event::PeerReaderGone{on_link, station});
  write(1);
  run(0.05);
  EXPECT_EQ(script_.wants, 0);
  EXPECT_EQ(script_.sent_on(on_link), 0U);
}

TEST_F(LinkRouterTest, WhileTheStateOfItsRoleIsPassiveClassLowIsSilent) {
  const FlowId low = begin("battery_state");
  const FlowId critical = begin("heartbeat", host_flow + 1);
  set_active(false, "gcs");  // not this side
  write(1);
  EXPECT_EQ(script_.sent_on(low), 1U);
  set_active(false);
  write(2);
  write(2, host_flow + 1);
  EXPECT_EQ(script_.sent_on(low), 1U);
  EXPECT_EQ(script_.sent_on(critical), 1U);
  set_active(true);
  write(3);
  EXPECT_EQ(script_.sent_on(low), 2U);
  EXPECT_EQ(script_.gate, (std::vector<bool>{false, true})) << "those who watch are told";
}

TEST_F(LinkRouterTest, OpensWhenTheControllerFallsSilent) {
  const FlowId low = begin("battery_state");
  set_active(false);
  write(1);
  run(4.9);
  EXPECT_EQ(script_.sent_on(low), 0U);
  run(0.2);
  write(2);
  EXPECT_EQ(script_.sent_on(low), 1U);
}

TEST_F(LinkRouterTest, TellsTheWritersOfAdaptiveTopicsTheirBudget) {
  begin("camera/image_raw/compressed");
  begin("heartbeat", host_flow + 1);
  run(1);
  const auto budgets = host_->budgets.take();
  ASSERT_FALSE(budgets.empty());
  ASSERT_EQ(budgets.back().streams().size(), 1U);
  EXPECT_EQ(budgets.back().streams()[0].topic(), "camera/image_raw/compressed");
  EXPECT_FLOAT_EQ(budgets.back().streams()[0].scale(), 1);
}

TEST_F(LinkRouterTest, KeepsToItsShareOfTheAirAndTellsWhatItUsed) {
  SimReader<topic::AirtimeUse> uses(host_->bus);
  run(2);
  EXPECT_TRUE(uses.take().empty()) << "nobody has told it a share";
  tocsin_msgs::msg::AirtimeShare share;
  share.share(0.02F);
  share.fallback(0.01F);
  host_->bus.publish<topic::AirtimeShare>(share);
  run(1.1);
  ASSERT_FALSE(uses.take().empty());
  const FlowId low = begin("camera/image_raw/compressed");
  meet();
  listen(low);
  write(1, host_flow, 3000);
  const auto first = script_.sent_on(low);
  EXPECT_GT(first, 0U);
  write(2, host_flow, 3000);
  EXPECT_EQ(script_.sent_on(low), first) << "3 kB take 0.3 s of a share of 0.02";
  run(1.1);
  const auto told = uses.take();
  ASSERT_FALSE(told.empty());
  EXPECT_FLOAT_EQ(told.back().share(), 0.02F);
  EXPECT_GT(told.back().used(), 0);
  run(6);
  EXPECT_FLOAT_EQ(uses.take().back().share(), 0.01F) << "the site is silent";
}

TEST_F(LinkRouterTest, BothSidesReckonWithAllWhoShareTheAir) {
  // Of a sample that is not acknowledged, after five that were after 60 ms.
  const auto sent_in_120_ms = [this](Role role, std::uint16_t vehicles) {
    start_as(role);
    tocsin_msgs::msg::AirtimeShare share;
    share.share(1);
    share.vehicles(vehicles);
    host_->bus.publish<topic::AirtimeShare>(share);
    const FlowId flow = begin("heartbeat");
    meet();
    begin_peer_flow("link_acknowledgement", acknowledgement_flow);
    listen(flow);
    for (std::uint32_t i = 1; i <= 5; ++i) {
      write(i);
      run(0.06);
      acknowledge(flow, i, i);
    }
    write(6);
    run(0.12);
    return script_.sent_on(flow) - 5;
  };
  for (const Role role : {Role::uxv, Role::gcs}) {
    EXPECT_EQ(sent_in_120_ms(role, 1), 2U) << to_string(role);
    EXPECT_EQ(sent_in_120_ms(role, 20), 1U) << to_string(role) << ": an answer may take longer";
  }
}

TEST_F(LinkRouterTest, TellsTheStateOfTheLinkAndOfEachTopicOnceASecond) {
  begin("battery_state");
  set_active(false);
  write(1);
  run(2.5);
  const auto states = host_->states.take();
  ASSERT_GE(states.size(), 2U);
  EXPECT_EQ(states.back().role(), "uxv");
  EXPECT_TRUE(states.back().paused());
  EXPECT_EQ(states.back().packets(), 7U);
  EXPECT_EQ(states.back().discovery_bytes(), 200U);
  EXPECT_EQ(states.back().acknowledgement_bytes(), 90U);
  EXPECT_EQ(states.back().backfill_bytes(), 50U);
  EXPECT_EQ(states.back().stop_bytes(), 40U);
  EXPECT_EQ(states.back().classes()[3].dropped_paused(), 1U);
  const auto reports = host_->reports.take();
  ASSERT_FALSE(reports.empty());
  ASSERT_EQ(reports.back().topics().size(), 1U);
  EXPECT_TRUE(reports.back().topics()[0].paused());
  EXPECT_EQ(reports.back().topics()[0].written(), 1U);
  EXPECT_EQ(reports.back().topics()[0].dropped(), 1U);
}

TEST_F(LinkRouterTest, ADurableSampleThatIsSentAgainToALatePeerCountsAsSentOnce) {
  Flow durable = flow("docking/status");
  durable.transient_local = true;
  script_.happen(link_event::HostFlow{host_flow, durable});
  run(0);
  const FlowId on_link = script_.opened_for("docking/status");
  write(1);
  meet();
  listen(on_link);
  run(2.5);
  ASSERT_GT(script_.sent_on(on_link), 1U) << "to nobody, then to the station";
  const auto reports = host_->reports.take();
  ASSERT_FALSE(reports.empty());
  ASSERT_EQ(reports.back().topics().size(), 1U);
  EXPECT_EQ(reports.back().topics()[0].written(), 1U);
  EXPECT_EQ(reports.back().topics()[0].sent(), 1U);
  EXPECT_EQ(reports.back().topics()[0].dropped(), 0U);
}

TEST_F(LinkRouterTest, ARestartedPeerIsAnsweredInItsNewInstance) {
  meet();
  begin_peer_flow("goal");
  receive(1, 10);
  run(0.2);
  meet(station + 1);
  script_.happen(link_event::PeerFlowGone{peer_flow});
  script_.happen(link_event::PeerLost{station});
  script_.happen(link_event::PeerFlow{peer_flow, station + 1, 5, flow("goal")});
  run(0);
  receive(1, 10);  // what the host has from its former instance
  receive(2, 11);
  EXPECT_EQ(script_.delivered.size(), 2U);
  run(0.2);
  const auto& acknowledgement =
      *static_cast<const Acknowledgement*>(script_.sent.back().sample.content.get());
  EXPECT_EQ(acknowledgement.to_instance(), station + 1);
}

TEST_F(LinkRouterTest, WhileTheLinkIsNotUpItGoesOn) {
  script_.is_up = false;
  meet();
  const FlowId on_link = begin("heartbeat");
  write(1);
  script_.is_up = true;
  write(2);
  EXPECT_EQ(script_.sent_on(on_link), 1U);
  EXPECT_EQ(script_.sent.back().sample.sequence, 2U);
}

TEST(LinkRouter, IsRefusedWhereThereIsNoLink) {
  SimBus bus;
  Context context{bus, "link_router", Role::uxv};
  EXPECT_THROW(LinkRouterComponent(context, {}), ConfigError);
}

}  // namespace
}  // namespace tocsin
