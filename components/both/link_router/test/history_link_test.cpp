// SPDX-License-Identifier: Apache-2.0
// Logged topics of a router on a scripted link: what is kept, what crosses when somebody asks.
#include <gmock/gmock.h>

#include "backfill_fixture.hpp"

namespace tocsin {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(HistoryLinkTest, WhatIsLoggedCrossesOnlyWhenTheStationAsks) {
  meet_station();
  (void)begin("odom");
  for (const std::uint64_t sequence : {1, 2, 3}) write(sequence);
  run(3);
  EXPECT_EQ(script_.opened_for("odom"), 0U) << "it has no flow on the link";
  EXPECT_THAT(sent(), IsEmpty());
  ask({request("odom")});
  run(3);
  EXPECT_THAT(sent(), ElementsAre(1, 2, 3));
  EXPECT_EQ(batches().at(0)->topic(), "odom");
  confirm(1, 1);
  const auto told = state();
  ASSERT_EQ(told.fetches().size(), 1U);
  EXPECT_EQ(told.fetches()[0].id(), 41U);
  EXPECT_EQ(told.fetches()[0].state(), "done");
  EXPECT_EQ(told.fetches()[0].found(), 3U);
  EXPECT_EQ(told.fetches()[0].delivered(), 3U);
  EXPECT_THAT(told.stored(), IsEmpty());
}

TEST_F(HistoryLinkTest, WhatWasDeliveredIsNotSentAgainAlsoByTheNextInstance) {
  meet_station();
  (void)begin("odom");
  for (const std::uint64_t sequence : {1, 2}) write(sequence);
  run(2);
  ask({request("odom")});
  run(3);
  EXPECT_THAT(sent(), ElementsAre(1, 2));
  confirm(1, 1);
  run(1);
  start();
  meet_station();
  (void)begin("odom");
  write(3);
  run(2);
  ask({request("odom", 3600, 42)});
  run(3);
  EXPECT_THAT(sent(), ElementsAre(3));
}

TEST_F(HistoryLinkTest, WhatCrossedLiveIsNotSentAgain) {
  meet_station();
  const FlowId on_link = begin("camera", camera_flow);
  listen(on_link);
  EXPECT_TRUE(script_.opened.at(on_link).flow.stored) << "the station notes what it delivers";
  write(1, camera_flow);
  acknowledge(on_link, 1);
  set_active(false);
  write(2, camera_flow);
  set_active(true);
  write(3, camera_flow);
  acknowledge(on_link, 2, 2);
  run(5);
  EXPECT_THAT(sent(), IsEmpty()) << "a logged topic is not backfilled by itself";
  ask({request("camera")});
  run(3);
  EXPECT_THAT(sent(), ElementsAre(2)) << "the one that the pause took";
}

TEST_F(HistoryLinkTest, WhatNobodyRepeatsIsNotSentAnyMore) {
  (void)begin("odom");
  for (std::uint64_t sequence = 1; sequence <= 400; ++sequence) write(sequence, host_flow, 900);
  run(2);
  meet_station();
  ask({request("odom")});
  run(120);
  const std::size_t count = sent().size();
  EXPECT_LT(count, 400U) << "nothing was confirmed";
  EXPECT_THAT(state().fetches(), IsEmpty());
}

TEST_F(HistoryLinkTest, SomebodyOnTheVehicleMayAsk) {
  meet_station();
  (void)begin("odom");
  write(1);
  run(2);
  host_->bus.publish<topic::LogRequest>(request("odom"));
  run(3);
  EXPECT_THAT(sent(), ElementsAre(1));
}

TEST_F(HistoryLinkTest, ATopicThatIsNotLoggedIsNotLookedFor) {
  meet_station();
  (void)begin("cpu_load");
  write(1);
  run(2);
  ask({request("cpu_load"), request("a b", 5, 42)});
  run(3);
  EXPECT_THAT(sent(), IsEmpty());
  EXPECT_THAT(state().fetches(), IsEmpty());
}

TEST_F(HistoryLinkTest,
       WhatThisHostWantsIsToldWithAcknowledgementsOnceASecondAsLongAsItIsRepeated) {
  meet_station();
  const auto told = [this] {
    std::size_t count = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_acknowledgement")) continue;
      const auto& requests =
          static_cast<const Acknowledgement*>(one.sample.content.get())->requests();
      count += requests.size();
      for (const auto& request : requests) EXPECT_EQ(request.topic(), "picture");
    }
    return count;
  };
  host_->bus.publish<topic::LogRequest>(request("picture"));
  run(3.5);
  EXPECT_GE(told(), 2U);
  EXPECT_LE(told(), 4U);
  run(10);
  const std::size_t until_forgotten = told();
  EXPECT_LE(until_forgotten, 7U);
  run(10);
  EXPECT_EQ(told(), until_forgotten);
}

}  // namespace
}  // namespace tocsin
