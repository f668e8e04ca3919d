// SPDX-License-Identifier: Apache-2.0
// Calls through a router on a scripted link and a scripted host, in virtual time.
#include <gmock/gmock.h>

#include <vector>

#include "call_link_fixture.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;

TEST_F(CallLinkTest, AServerOfTheHostIsToldAndShownOnThePeersHost) {
  begin_as(Role::uxv);
  happen(host_service_event::Server{dock, true});
  const auto told = sent<ServicesMessage>(link_services_topic);
  ASSERT_FALSE(told.empty());
  ASSERT_EQ(told.back().offered().size(), 1U);
  EXPECT_EQ(told.back().offered()[0].name(), "dock");
  begin_as(Role::gcs);
  hear_of({dock}, {});
  EXPECT_EQ(script_.services.served.at("dock"), dock);
  hear_of({}, {});
  EXPECT_THAT(script_.services.served, IsEmpty());
}

TEST_F(CallLinkTest, ARequestCrossesAndItsReplyReachesTheClientThatAsked) {
  begin_as(Role::gcs);
  hear_of({dock}, {});
  happen(host_service_event::Request{"dock", id(1), question});
  happen(host_service_event::Request{"dock", id(2), answer});
  const auto sent = sent_calls();
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_FALSE(sent[0].reply());
  EXPECT_EQ(sent[0].caller(), ScriptedLink::own_instance);
  EXPECT_EQ(sent[0].service(), "dock");
  EXPECT_EQ(sent[0].data(), question);
  receive(peer_calls, call(ScriptedLink::own_instance, sent[1].number(), true, answer));
  ASSERT_EQ(script_.services.replied.size(), 1U);
  EXPECT_EQ(script_.services.replied[0].id.client, id(2).client);
  EXPECT_EQ(script_.services.replied[0].message, answer);
}

TEST_F(CallLinkTest, ARequestOfAPeerIsAskedOnceAndItsReplyCrosses) {
  begin_as(Role::uxv);
  hear_of({}, {dock});
  EXPECT_THAT(script_.services.called, Contains(Key("dock")));
  receive(peer_calls, call(station, 9, false, question));
  ASSERT_EQ(script_.services.asked.size(), 1U);
  EXPECT_EQ(script_.services.asked[0].message, question);
  happen(host_service_event::Reply{"dock", 1, answer});
  happen(host_service_event::Reply{"dock", 1, answer});
  const auto sent = sent_calls();
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_TRUE(sent[0].reply());
  EXPECT_EQ(sent[0].caller(), station);
  EXPECT_EQ(sent[0].number(), 9U);
  EXPECT_EQ(sent[0].data(), answer);
}

TEST_F(CallLinkTest, ARequestWaitsForItsServerUntilTheDeadline) {
  begin_as(Role::uxv);
  script_.services.has_server = false;
  hear_of({}, {dock});
  receive(peer_calls, call(station, 1, false, question));
  run(1.5);
  EXPECT_THAT(script_.services.asked, IsEmpty());
  script_.services.has_server = true;
  happen(host_service_event::Changed{"dock"});
  EXPECT_EQ(script_.services.asked.size(), 1U);
  script_.services.has_server = false;
  receive(peer_calls, call(station, 2, false, question));
  run(2.1);
  script_.services.has_server = true;
  happen(host_service_event::Changed{"dock"});
  EXPECT_EQ(script_.services.asked.size(), 1U);
}

TEST_F(CallLinkTest, AReplyAfterTheDeadlineOfItsCallReachesNobody) {
  begin_as(Role::gcs);
  hear_of({dock}, {});
  happen(host_service_event::Request{"dock", id(1), question});
  run(2.1);
  receive(peer_calls, call(ScriptedLink::own_instance, 1, true, answer));
  EXPECT_THAT(script_.services.replied, IsEmpty());
}

TEST_F(CallLinkTest, RepliesToAnotherInstanceAreIgnored) {
  begin_as(Role::gcs);
  hear_of({dock}, {});
  happen(host_service_event::Request{"dock", id(1), question});
  receive(peer_calls, call(ScriptedLink::own_instance + 1, 1, true, answer));
  EXPECT_THAT(script_.services.replied, IsEmpty());
}

TEST_F(CallLinkTest, ARequestThatIsNotAcknowledgedIsSentAgainAndNotAfterItsDeadline) {
  begin_as(Role::gcs);
  hear_of({dock}, {});
  listen(script_.opened_for("link_calls_uxv_high"));
  happen(host_service_event::Request{"dock", id(1), question});
  run(1.9);
  const std::size_t before = sent_calls().size();
  EXPECT_GE(before, 3U);
  run(0.2);
  const std::size_t at_its_end = sent_calls().size();
  run(5);
  EXPECT_EQ(sent_calls().size(), at_its_end);
}

TEST_F(CallLinkTest, TheResultOfAnActionIsWaitedForLongerThanACall) {
  begin_as(Role::gcs);
  const HostService result{"drive/_action/get_result", "nav2_msgs/action/Drive_GetResult"};
  hear_of({result}, {});
  happen(host_service_event::Request{result.name, id(1), question});
  EXPECT_EQ(sent<CallMessage>("link_results_uxv_high").size(), 1U);
  run(600);
  begin_peer_flow("link_results_uxv_high", peer_calls + 10);
  CallMessage reply = call(ScriptedLink::own_instance, 1, true, answer);
  reply.service(result.name);
  receive(peer_calls + 10, reply);
  EXPECT_EQ(script_.services.replied.size(), 1U);
}

TEST_F(CallLinkTest, NamesOfAPeerThatCanBeNoneAreIgnored) {
  begin_as(Role::gcs);
  hear_of({{"dock\n", dock.type}, {"dock", "std_srvs::srv"}, {"", ""}}, {});
  EXPECT_THAT(script_.services.served, IsEmpty());
}

/// What is refused of a peer's services, and how much of them is taken.
using CallBoundsTest = CallLinkTest;

TEST_F(CallBoundsTest, WhatTheRulesDoNotNameIsCountedAsRefused) {
  begin_as(Role::uxv);
  const auto before = refused_names().total();
  CallMessage message = call(station, 1, false, question);
  message.service("self_destruct");
  receive(peer_calls, message);
  hear_of({dock}, {{"self_destruct", "std_srvs/srv/Trigger"}});  // this side has no server to call
  EXPECT_EQ(refused_names().total() - before, 3U);
  EXPECT_THAT(script_.services.called, IsEmpty());
  EXPECT_THAT(script_.services.asked, IsEmpty());
  EXPECT_THAT(script_.services.served, IsEmpty());
}

TEST_F(CallBoundsTest, OfManyNamesEndsAreMadeAFewATickAndNotOfAll) {
  begin_as(Role::uxv);
  std::vector<HostService> wanted;
  for (int i = 0; i < 700; ++i) {
    wanted.push_back({"n" + std::to_string(i) + "/get_parameters", "rcl_interfaces/srv/Get"});
  }
  hear_of({}, wanted);
  EXPECT_LE(script_.services.called.size(), 8U);
  run(5);
  EXPECT_EQ(script_.services.called.size(), 256U);
  hear_of({}, {dock});
  EXPECT_EQ(script_.services.called.size(), 1U);
}

TEST_F(CallBoundsTest, HundredsOfNamesDoNotDisplaceWhatTheFileNames) {
  begin_as(Role::uxv);
  hear_of({}, {dock});
  EXPECT_EQ(script_.services.called.count("dock"), 1U);
  std::vector<HostService> wanted{dock};
  for (int i = 0; i < 700; ++i) {
    wanted.push_back({"a" + std::to_string(i) + "/get_parameters", "rcl_interfaces/srv/Get"});
  }
  hear_of({}, wanted);
  run(5);
  EXPECT_EQ(script_.services.called.count("dock"), 1U);
}

}  // namespace
}  // namespace tocsin
