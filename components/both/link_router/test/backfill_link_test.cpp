// SPDX-License-Identifier: Apache-2.0
// Stored topics of a router on a scripted link: what it sends, delivers and keeps over instances.
#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "backfill_fixture.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(BackfillLinkTest, WhatAPauseHeldIsBackfilledAfterIt) {
  meet_station();
  listen(begin("battery_state"));
  set_active(false);
  for (const std::uint64_t sequence : {1, 2, 3}) write(sequence);
  EXPECT_THAT(sent(), IsEmpty()) << "nothing while paused";
  set_active(true);
  EXPECT_THAT(sent(), ElementsAre(1, 2, 3));
  confirm(1, 1);
  const auto state = StoreTest::state().stored().at(0);
  EXPECT_EQ(state.topic(), "battery_state");
  EXPECT_EQ(state.stored(), 3U);
  EXPECT_EQ(state.backfilled(), 3U);
  EXPECT_EQ(state.waiting(), 0U);
  EXPECT_TRUE(script_.opened.at(script_.opened_for("battery_state")).flow.stored);
}

TEST_F(BackfillLinkTest, WhatIsBackfilledAndAcknowledgedIsNotLost) {
  meet_station();
  listen(begin("battery_state"));
  set_active(false);
  for (const std::uint64_t sequence : {1, 2, 3}) write(sequence);
  set_active(true);
  ASSERT_THAT(sent(), ElementsAre(1, 2, 3));
  acknowledge(backfills(), static_cast<std::uint32_t>(batches().size()));
  EXPECT_EQ(state().loss(), 0);
}

TEST_F(BackfillLinkTest, WhatTheNextInstanceFindsInTheLogIsBackfilledThoughNobodyWritesItNow) {
  (void)begin("battery_state");
  write(1);
  write(2);
  run(1);
  start();
  meet_station();
  EXPECT_THAT(sent(), ElementsAre(1, 2));
  EXPECT_EQ(batches().front()->topic(), "battery_state");
  confirm(1, 1);
  start();
  meet_station();
  run(3);
  EXPECT_THAT(sent(), IsEmpty()) << "confirmed";
}

TEST_F(BackfillLinkTest, AFolderThatCannotBeUsedCostsOnlyWhatWouldHaveBeenStored) {
  start("traffic.yaml/store");
  meet_station();
  const FlowId on_link = begin("battery_state");
  listen(on_link);
  write(1);
  EXPECT_EQ(script_.sent_on(on_link), 1U);
  acknowledge(on_link, 1);
  set_active(false);
  write(2);
  set_active(true);
  run(3);
  EXPECT_THAT(sent(), IsEmpty());
  const auto state = StoreTest::state().stored().at(0);
  EXPECT_EQ(state.stored(), 0U);
  EXPECT_EQ(state.refused(), 1U) << "the one that did not cross";
}

TEST_F(BackfillLinkTest, ABatchWaitsUntilAReaderOfTheHostHearsItsTopic) {
  script_.host_reads = false;
  meet_station();
  begin_peer_flow(backfill_topic, peer_backfills);
  backfill(1, {10, 11});
  backfill(2, {12});
  backfill(1, {10, 11});
  EXPECT_THAT(delivered(), IsEmpty());
  EXPECT_EQ(confirmed_number(), 0U) << "it is not done with";
  ASSERT_EQ(script_.offered_here.size(), 1U);
  script_.happen(link_event::HostReaderMatched{script_.offered_here.begin()->first});
  run(0.1);
  EXPECT_THAT(delivered(), IsEmpty()) << "other readers may follow";
  run(0.1);
  EXPECT_THAT(delivered(), ElementsAre(10, 11, 12));
  EXPECT_EQ(confirmed_number(), 2U);
  backfill(3, {13});
  EXPECT_THAT(delivered(), ElementsAre(10, 11, 12, 13));
}

TEST_F(BackfillLinkTest, ALiveSampleIsConfirmedWhenReadersOfTheHostHaveFoundItsTopic) {
  script_.host_reads = false;
  meet_station();
  begin_stored_peer_flow();
  receive(1, 10);
  receive(2, 11);
  run(1.1);
  EXPECT_THAT(delivered(), IsEmpty());
  EXPECT_EQ(confirmed_of(peer_flow + 1), 0U) << "else it is lost if this router is killed now";
  script_.happen(link_event::HostReaderMatched{peer_flow});
  run(0.2);
  receive(3, 12);
  EXPECT_THAT(delivered(), ElementsAre(10, 11, 12));
  run(0.1);
  EXPECT_EQ(confirmed_of(peer_flow + 1), 3U);
}

TEST_F(BackfillLinkTest, TheNextInstanceRemembersWhatWasDelivered) {
  meet_station();
  begin_peer_flow(backfill_topic, peer_backfills);
  backfill(1, {10, 11});
  start();
  script_.delivered.clear();
  meet_station();
  begin_peer_flow(backfill_topic, peer_backfills);
  backfill(1, {11, 12});
  EXPECT_THAT(delivered(), ElementsAre(12));
}

TEST_F(BackfillLinkTest, ABatchOfNoTopicIsIgnored) {
  meet_station();
  begin_peer_flow(backfill_topic, peer_backfills);
  for (const char* const topic : {"", "a b", "a\n"}) backfill(1, {10}, topic);
  EXPECT_THAT(delivered(), IsEmpty());
  EXPECT_EQ(confirmed_number(), 0U);
}

TEST_F(BackfillLinkTest, AHistoryThatNoRuleSendsHereIsNotDeliveredAndHoldsUpNothing) {
  meet_station();
  begin_peer_flow(backfill_topic, peer_backfills);
  const auto refused = refused_names().total();
  backfill(1, {10}, "cmd_vel");
  backfill(2, {11}, "goal");
  EXPECT_THAT(delivered(), ElementsAre(11));
  EXPECT_EQ(script_.offered_here.size(), 1U);
  EXPECT_EQ(refused_names().total(), refused + 1);
  EXPECT_EQ(confirmed_number(), 2U);
}

}  // namespace
}  // namespace tocsin
