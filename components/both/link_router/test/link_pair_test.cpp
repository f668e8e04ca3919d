// SPDX-License-Identifier: Apache-2.0
// What both routers do together: priority, repair, pause, restarts.
#include "link_pair.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;
constexpr std::size_t picture_bytes = 40000;

/// So that the capacity is known: pictures for 3 s, and something small.
void learn_capacity(LinkPair& link, StreamId camera) {
  std::uint64_t sequence = 1;
  link.add(90, rule_of(Priority::normal));
  link.offer(90, 1);
  link.run(100 * ms);
  for (int i = 0; i < 20; ++i) {
    link.offer(camera, sequence++, picture_bytes);
    link.run(150 * ms);
  }
}

TEST(LinkPairTest, DeliversWhatIsOffered) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.offer(1, 1);
  link.run(200 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.sent.size(), 1U);
  EXPECT_EQ(link.counts(Priority::critical).delivered, 1U);
  EXPECT_EQ(link.counts(Priority::critical).late, 0U);
}

TEST(LinkPairTest, SendsClassesInTheirOrder) {
  LinkPair link;
  const Priority reversed[] = {Priority::low, Priority::normal, Priority::high, Priority::critical};
  for (StreamId stream = 0; stream < 4; ++stream) link.add(stream, rule_of(reversed[stream]));
  for (StreamId stream = 0; stream < 4; ++stream) link.offer(stream, 1);
  link.run(ms);
  ASSERT_EQ(link.sent.size(), 4U);
  for (StreamId i = 0; i < 4; ++i) EXPECT_EQ(link.sent[i].stream, 3 - i);
}

TEST(LinkPairTest, RepairsALostSampleAfterATenthOfASecond) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.dead = true;
  link.offer(1, 1);
  link.run(100 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  link.dead = false;
  link.run(20 * ms);
  ASSERT_EQ(link.sent.size(), 2U);
  EXPECT_TRUE(link.sent[1].repair);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  link.run(200 * ms);
  EXPECT_EQ(link.counts(Priority::critical).repaired, 1U);
  EXPECT_EQ(link.counts(Priority::critical).repairs, 1U);
}

TEST(LinkPairTest, DoesNotRepairClassLow) {
  LinkPair link;
  link.add(1, rule_of(Priority::low));
  link.dead = true;
  link.offer(1, 1);
  link.run(2000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  EXPECT_EQ(link.counts(Priority::low).lost, 1U);
}

TEST(LinkPairTest, BacksOffWhileNothingIsAcknowledged) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::critical);
  rule.durable = true;
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(350 * ms);
  EXPECT_EQ(link.sent.size(), 3U) << "at 0, 100, 300 ms";
  link.run(4650 * ms);
  EXPECT_LE(link.sent.size(), 13U) << "then twice a second";
  EXPECT_GE(link.sent.size(), 11U);
}

TEST(LinkPairTest, NeverRepairsWhatANewerOneHasFollowed) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.dead = true;
  link.offer(1, 1);
  link.run(50 * ms);
  link.offer(1, 2);
  link.run(3000 * ms);
  for (const Transmission& one : link.sent) {
    EXPECT_TRUE(!one.repair || one.sample.origin.sequence == 2U);
  }
  EXPECT_EQ(link.counts(Priority::critical).lost, 1U);
}

TEST(LinkPairTest, RepairsAllOfADeeperStream) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::high);
  rule.depth = 3;
  link.add(1, rule);
  link.dead = true;
  for (std::uint64_t sequence = 1; sequence <= 4; ++sequence) link.offer(1, sequence);
  link.run(ms);
  link.dead = false;
  link.run(300 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{2, 3, 4}));
}

TEST(LinkPairTest, RepairsOnlyWithinTheLifespan) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::critical);
  rule.lifespan = 250 * ms;
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(5000 * ms);
  EXPECT_EQ(link.sent.size(), 2U) << "at 0 and 100 ms; 300 ms is too late";
}

TEST(LinkPairTest, GivesUpASampleWithoutALifespanAfterABoundUnlessItIsDurable) {
  LinkPair link;
  StreamRule durable = rule_of(Priority::critical);
  durable.durable = true;
  link.add(1, rule_of(Priority::critical));
  link.add(2, durable);
  link.dead = true;
  link.offer(1, 1);
  link.offer(2, 1);
  link.run(6000 * ms);
  link.dead = false;
  link.run(1000 * ms);
  EXPECT_TRUE(link.delivered[1].empty());
  EXPECT_EQ(link.delivered[2], (Sequences{1}));
}

TEST(LinkPairTest, LostReceiptsCostARepairAndNoSecondDelivery) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.receipts_lost = true;
  link.offer(1, 1);
  link.run(90 * ms);
  link.receipts_lost = false;
  link.run(300 * ms);
  EXPECT_EQ(link.sent.size(), 2U);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.counts(Priority::critical).delivered, 1U);
}

TEST(LinkPairTest, BulkWaitsUntilTheRadioHasSentTheOneBefore) {
  LinkPair link;
  StreamRule camera = rule_of(Priority::low);
  link.add(1, camera);
  link.add(2, rule_of(Priority::critical));
  learn_capacity(link, 1);
  const std::size_t before = link.sent.size();
  link.offer(1, 100, picture_bytes);
  link.run(ms);
  link.offer(1, 101, picture_bytes);
  link.offer(2, 1);
  link.run(3 * ms);
  ASSERT_EQ(link.sent.size(), before + 2) << "the second picture waits, the small one does not";
  EXPECT_EQ(link.sent.back().stream, 2U);
  link.run(40 * ms);
  EXPECT_EQ(link.sent.back().sample.origin.sequence, 101U);
}

TEST(LinkPairTest, ANewerPictureTakesThePlaceOfTheOneThatWaits) {
  LinkPair link;
  link.add(1, rule_of(Priority::low));
  learn_capacity(link, 1);
  for (std::uint64_t sequence = 100; sequence < 103; ++sequence) {
    link.offer(1, sequence, picture_bytes);
    link.run(ms);
  }
  link.run(100 * ms);
  EXPECT_EQ(link.delivered[1].back(), 102U);
  const auto counts = link.counts(Priority::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::superseded)], 1U);
}

TEST(LinkPairTest, LearnsTheCapacityAndTheBudgetFollows) {
  LinkPair link;
  StreamRule camera = rule_of(Priority::low);
  camera.adaptive = true;
  link.add(1, camera);
  learn_capacity(link, 1);
  std::uint64_t sequence = 100;
  for (int i = 0; i < 200; ++i) {
    link.offer(1, sequence++, picture_bytes);
    link.run(125 * ms);
  }
  const LinkStateValues state = link.sender.state(link.now);
  EXPECT_NEAR(state.capacity_bytes_per_s, 1.35e6, 0.2e6) << "a packet of 1350 B each ms";
  const auto budgets = link.sender.budgets(link.now);
  ASSERT_EQ(budgets.size(), 1U);
  EXPECT_EQ(budgets[0].scale, 1);
  EXPECT_FALSE(budgets[0].hold);
  EXPECT_NEAR(budgets[0].bytes_per_s, 375e3, 40e3) << "47 kB on the wire, 8 a second";
}

TEST(LinkPairTest, AnAdaptiveSourceHoldsWhileItsLastSampleWaits) {
  LinkPair link;
  StreamRule camera = rule_of(Priority::low);
  camera.adaptive = true;
  link.add(1, camera);
  for (std::uint64_t sequence = 1; sequence < 3; ++sequence) link.offer(1, sequence, picture_bytes);
  EXPECT_TRUE(link.sender.budgets(link.now).at(0).hold);
  link.run(ms);
  link.offer(1, 3, picture_bytes);
  link.run(ms);
  EXPECT_TRUE(link.sender.budgets(link.now).at(0).hold);
  link.run(1000 * ms);
  EXPECT_FALSE(link.sender.budgets(link.now).at(0).hold);
}

TEST(LinkPairTest, AShortBudgetThinsATopicDownToItsRate) {
  LinkPair link;
  StreamRule camera = rule_of(Priority::low);
  camera.adaptive = true;
  StreamRule load = rule_of(Priority::low);
  load.min_rate_hz = 2;
  link.add(1, camera);
  link.add(2, load);
  std::uint64_t sequence = 1;
  // Pictures too large for the link: the scale falls to its least.
  const auto play = [&] {
    for (int i = 0; i < 80; ++i) {
      if (i % 2 == 0) link.offer(1, sequence, 300000);
      link.offer(2, sequence++);
      link.run(50 * ms);
    }
  };
  play();
  EXPECT_LT(link.sender.state(link.now).scale, 0.35);
  const std::size_t before = link.count_sent(2);
  play();
  const std::size_t thinned = link.count_sent(2) - before;
  EXPECT_GE(thinned, 8U) << "2 a second at least";
  EXPECT_LE(thinned, 30U) << "of 20 a second";
  EXPECT_GT(link.counts(Priority::low).dropped[static_cast<std::size_t>(DropReason::thinned)], 20U);
}

TEST(LinkPairTest, WhatIsPausedIsSilentAndTheNewestFollows) {
  LinkPair link;
  StreamRule drops = rule_of(Priority::low);
  drops.while_paused = WhilePaused::drop;
  StreamRule keeps = rule_of(Priority::low);
  keeps.while_paused = WhilePaused::latest;
  link.add(1, drops);
  link.add(2, keeps);
  link.add(3, rule_of(Priority::critical));
  link.sender.set_paused(true, link.now);
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    for (const StreamId stream : {1, 2, 3}) link.offer(stream, sequence);
    link.run(100 * ms);
  }
  EXPECT_TRUE(link.delivered[1].empty());
  EXPECT_TRUE(link.delivered[2].empty());
  EXPECT_EQ(link.delivered[3], (Sequences{1, 2, 3}));
  EXPECT_EQ(link.sender.state(link.now).classes[3].waiting_samples, 1U);
  link.sender.set_paused(false, link.now);
  link.run(100 * ms);
  EXPECT_TRUE(link.delivered[1].empty());
  EXPECT_EQ(link.delivered[2], (Sequences{3}));
  const auto counts = link.counts(Priority::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::paused)], 5U);
}

TEST(LinkPairTest, WhatOutlivedThePauseOnlyByAgeIsNotSent) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::low);
  rule.while_paused = WhilePaused::latest;
  rule.lifespan = 1000 * ms;
  link.add(1, rule);
  link.sender.set_paused(true, link.now);
  link.offer(1, 1);
  link.run(1001 * ms);
  link.sender.set_paused(false, link.now);
  link.run(100 * ms);
  EXPECT_TRUE(link.sent.empty());
  const auto counts = link.counts(Priority::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::expired)], 1U);
}

TEST(LinkPairTest, APauseTakesWhatWaits) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::low);
  rule.while_paused = WhilePaused::drop;
  link.add(1, rule);
  link.offer(1, 1);
  link.sender.set_paused(true, link.now);
  link.run(100 * ms);
  EXPECT_TRUE(link.sent.empty());
}

TEST(LinkPairTest, RepairsOfAPausedStreamWait) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::high);
  rule.while_paused = WhilePaused::latest;
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(50 * ms);
  link.dead = false;
  link.sender.set_paused(true, link.now);
  link.run(1000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  link.sender.set_paused(false, link.now);
  link.run(100 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
}

TEST(LinkPairTest, AFreshSampleCrossesWithinASecondOfTheLinksReturn) {
  for (const int dead_s : {1, 5, 30}) {
    LinkPair link;
    link.add(1, rule_of(Priority::critical));
    link.add(2, rule_of(Priority::low));
    std::uint64_t sequence = 0;
    const auto play = [&](Duration length) {
      for (const Time end = link.now + length; link.now < end;) {
        link.offer(1, ++sequence);
        link.offer(2, sequence, picture_bytes);
        link.run(500 * ms);
      }
    };
    play(std::chrono::seconds(3));
    link.dead = true;
    play(std::chrono::seconds(dead_s));
    link.dead = false;
    const std::size_t critical = link.delivered[1].size();
    const std::size_t low = link.delivered[2].size();
    play(std::chrono::seconds(1));
    EXPECT_GT(link.delivered[1].size(), critical) << dead_s << " s";
    EXPECT_GT(link.delivered[2].size(), low) << dead_s << " s";
    EXPECT_EQ(link.sender.state(link.now).silent_peers, 0U);
  }
}

TEST(LinkPairTest, ADeadLinkGetsOnlyWhatCouldFindItAlive) {
  LinkPair link;
  link.add(1, rule_of(Priority::low));
  learn_capacity(link, 1);
  link.dead = true;
  const std::size_t before = link.sent.size();
  for (std::uint64_t sequence = 100; sequence < 180; ++sequence) {
    link.offer(1, sequence, picture_bytes);
    link.run(125 * ms);
  }
  EXPECT_EQ(link.sender.state(link.now).silent_peers, 1U);
  EXPECT_LE(link.sent.size() - before, 26U) << "10 s: about two a second";
  EXPECT_GE(link.sent.size() - before, 15U);
}

TEST(LinkPairTest, ALatePeerGetsTheNewestOfADurableStream) {
  LinkPair link;
  StreamRule durable = rule_of(Priority::critical);
  durable.durable = true;
  link.add(1, durable);
  link.add(2, rule_of(Priority::critical));
  link.sender.set_wanted("station", 1, false, link.now);
  link.sender.set_wanted("station", 2, false, link.now);
  link.dead = true;  // nobody is there
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    link.offer(1, sequence);
    link.offer(2, sequence);
    link.run(10 * ms);
  }
  link.run(10000 * ms);
  link.dead = false;
  link.sender.set_wanted("station", 1, true, link.now);
  link.sender.set_wanted("station", 2, true, link.now);
  link.run(50 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{3}));
  EXPECT_TRUE(link.delivered[2].empty());
  EXPECT_EQ(link.counts(Priority::critical).unwanted, 6U);
}

TEST(LinkPairTest, ARestartedPeerGetsTheStateAgain) {
  LinkPair link;
  StreamRule durable = rule_of(Priority::critical);
  durable.durable = true;
  link.add(1, durable);
  link.offer(1, 1);
  link.run(200 * ms);
  link.receiver = LinkReceiver({}, 3);
  link.receiver.on_peer("vehicle", 1);
  link.receiver.on_stream("vehicle", 1, durable);
  link.sender.on_peer("station", 3, link.now);
  link.sender.set_wanted("station", 1, true, link.now);
  link.delivered.clear();
  link.run(200 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
}

TEST(LinkPairTest, ReceiptsOfAnotherLifeAreIgnored) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.receipts_lost = true;
  link.offer(1, 1);
  link.run(60 * ms);
  LinkReceipt receipt{2, 1, 50, link.now, 200, {{1, 1, 50 * ms, 0}}};
  for (auto [from, to] : {std::pair{9U, 1U}, std::pair{2U, 9U}}) {
    receipt.from = from;
    receipt.to = to;
    link.sender.on_receipt("station", receipt, link.now);
    EXPECT_EQ(link.counts(Priority::critical).delivered, 0U);
  }
  receipt.from = 2;
  receipt.to = 1;
  link.sender.on_receipt("nobody", receipt, link.now);
  EXPECT_EQ(link.counts(Priority::critical).delivered, 0U);
  link.sender.on_receipt("station", receipt, link.now);
  EXPECT_EQ(link.counts(Priority::critical).delivered, 1U);
}

TEST(LinkPairTest, RepairsUntilEachPeerThatWantsItHasIt) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.sender.on_peer("second", 5, link.now);
  link.sender.set_wanted("second", 1, true, link.now);
  link.offer(1, 1);
  link.run(200 * ms);
  EXPECT_GE(link.sent.size(), 2U) << "the second has acknowledged nothing";
  EXPECT_EQ(link.counts(Priority::critical).delivered, 0U);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  const LinkReceipt receipt{5, 1, 1, link.now, 200, {{1, 2, 5 * ms, 0}}};
  link.sender.on_receipt("second", receipt, link.now);
  const std::size_t before = link.sent.size();
  EXPECT_EQ(link.counts(Priority::critical).delivered, 1U);
  link.run(2000 * ms);
  EXPECT_EQ(link.sent.size(), before);
}

TEST(LinkPairTest, APeerThatIsGoneIsNotWaitedFor) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.dead = true;
  link.offer(1, 1);
  link.run(10 * ms);
  link.sender.forget_peer("station", link.now);
  link.run(2000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  EXPECT_EQ(link.counts(Priority::critical).unwanted, 1U);
}

TEST(LinkPairTest, ATransmissionThatWasNotWrittenGivesItsNumberBack) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.offer(1, 1);
  const auto refused = link.sender.next(link.now);
  ASSERT_TRUE(refused);
  link.sender.on_not_written(*refused, link.now);
  link.run(300 * ms);  // asserts that the numbers begin with 1
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
}

TEST(LinkPairTest, ARemovedStreamLeavesNothingBehind) {
  LinkPair link;
  StreamRule rule = rule_of(Priority::critical);
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(10 * ms);
  link.offer(1, 2);
  link.sender.remove_stream(1);
  link.run(3000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  const auto counts = link.counts(Priority::critical);
  EXPECT_EQ(counts.lost, 1U);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::removed)], 1U);
}

TEST(LinkPairTest, LateIsCountedFromTheOffer) {
  LinkPair link;
  link.add(1, rule_of(Priority::critical));
  link.offer(1, 1);
  link.run(200 * ms);
  link.dead = true;
  link.offer(1, 2);
  link.run(260 * ms);
  link.dead = false;
  link.run(500 * ms);
  const auto counts = link.counts(Priority::critical);
  EXPECT_EQ(counts.delivered, 2U);
  EXPECT_EQ(counts.late, 1U);
  EXPECT_EQ(late_or_lost(counts), 0.5);
}

TEST(LinkPairTest, ReceiptsAreFewAndStopWithTheTraffic) {
  LinkPair link;
  link.add(1, rule_of(Priority::high));
  std::uint64_t sequence = 0;
  int step = 0;
  link.run(10000 * ms, [&] {
    if (step++ % 20 == 0) link.offer(1, ++sequence);
  });
  EXPECT_LE(link.receipts, 170) << "50 samples a second";
  link.receipts = 0;
  link.run(10000 * ms);
  EXPECT_LE(link.receipts, 11);
  EXPECT_GE(link.receipts, 9);
}

}  // namespace
}  // namespace tocsin::router
