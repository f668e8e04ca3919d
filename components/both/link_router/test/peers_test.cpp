// SPDX-License-Identifier: Apache-2.0
// Delivery, peers and their instances, streams that come and go.
#include "link_pair.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;

TEST(Peers, ALatePeerGetsTheNewestOfADurableStream) {
  LinkPair link;
  StreamRule durable = rule_of(TrafficClass::critical);
  durable.durable = true;
  link.add(1, durable);
  link.add(2, rule_of(TrafficClass::critical));
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
  EXPECT_EQ(link.counts(TrafficClass::critical).unwanted, 6U);
}

TEST(Peers, WhatIsOnDemandIsSentWhileSomebodyWantsIt) {
  LinkPair link;
  StreamRule on_demand = rule_of(TrafficClass::low);
  on_demand.on_demand = true;
  link.add(1, on_demand);
  link.sender.set_wanted("station", 1, false, link.now);
  link.offer(1, 1);
  link.run(50 * ms);
  EXPECT_TRUE(link.sent.empty());
  EXPECT_EQ(link.counts(TrafficClass::low).offered, 0U) << "not counted as lost either";
  link.sender.set_wanted("station", 1, true, link.now);
  link.offer(1, 2);
  link.run(50 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{2}));
  link.sender.set_wanted("station", 1, false, link.now);
  link.offer(1, 3);
  link.run(50 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{2}));
}

TEST(Peers, OnDemandALatePeerGetsTheNewestOfADurableStreamToo) {
  LinkPair link;
  StreamRule durable = rule_of(TrafficClass::low);
  durable.durable = true;
  durable.on_demand = true;
  link.add(1, durable);
  link.sender.set_wanted("station", 1, false, link.now);
  link.offer(1, 1);
  link.offer(1, 2);
  link.run(10000 * ms);
  EXPECT_TRUE(link.sent.empty());
  link.sender.set_wanted("station", 1, true, link.now);
  link.run(50 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{2}));
}

TEST(Peers, ARestartedPeerGetsTheStateAgain) {
  LinkPair link;
  StreamRule durable = rule_of(TrafficClass::critical);
  durable.durable = true;
  link.add(1, durable);
  link.offer(1, 1);
  link.run(200 * ms);
  link.receiver = LinkReceiver();
  link.receiver.on_peer("vehicle", 1);
  link.receiver.on_stream("vehicle", 1, durable);
  link.sender.on_peer("station", 3, link.now);
  link.sender.set_wanted("station", 1, true, link.now);
  link.delivered.clear();
  link.run(200 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
}

TEST(Peers, AcknowledgementsOfOthersAreIgnored) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.acknowledgements_lost = true;
  link.offer(1, 1);
  link.run(60 * ms);
  const LinkAcknowledgement acknowledgement{50, link.now, {{1, 1, 50 * ms, 0}}};
  link.sender.on_acknowledgement("nobody", acknowledgement, link.now);
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 0U);
  link.sender.on_acknowledgement("station", acknowledgement, link.now);
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 1U);
}

TEST(Peers, AForgedCountSilencesNoAcknowledgement) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.run(200 * ms);
  link.sender.on_acknowledgement("station", {~0U, link.now, {}}, link.now);
  link.offer(1, 1);
  link.run(200 * ms);
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 1U);
  EXPECT_EQ(link.sent.size(), 1U);
}

TEST(Peers, RepairsUntilEachPeerThatWantsItHasIt) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.sender.on_peer("second", 5, link.now);
  link.sender.set_wanted("second", 1, true, link.now);
  link.offer(1, 1);
  link.run(200 * ms);
  EXPECT_GE(link.sent.size(), 2U) << "the second has acknowledged nothing";
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 0U);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  const LinkAcknowledgement acknowledgement{1, link.now, {{1, 2, 5 * ms, 0}}};
  link.sender.on_acknowledgement("second", acknowledgement, link.now);
  const std::size_t before = link.sent.size();
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 1U);
  link.run(2000 * ms);
  EXPECT_EQ(link.sent.size(), before);
}

TEST(Peers, ASilentPeerDoesNotHoldTheOthersUp) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  learn_capacity(link, 1);
  link.sender.on_peer("second", 5, link.now);
  link.sender.set_wanted("second", 1, true, link.now);
  std::uint64_t sequence = 100;
  const auto play = [&](int pictures) {
    for (int i = 0; i < pictures; ++i) {
      link.offer(1, ++sequence, picture_bytes);
      link.run(200 * ms);
    }
  };
  play(10);
  EXPECT_EQ(link.sender.state(link.now).silent_peers, 1U);
  EXPECT_EQ(link.sender.state(link.now).live_peers, 1U);
  const std::size_t before = link.delivered[1].size();
  play(20);
  EXPECT_GE(link.delivered[1].size() - before, 19U);
}

TEST(Peers, APeerThatIsGoneIsNotWaitedFor) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.dead = true;
  link.offer(1, 1);
  link.run(10 * ms);
  link.sender.forget_peer("station", link.now);
  link.run(2000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  EXPECT_EQ(link.counts(TrafficClass::critical).unwanted, 1U);
}

TEST(Peers, ATransmissionThatWasNotWrittenIsRepairedWithoutAGapInTheNumbers) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.offer(1, 1);
  ASSERT_TRUE(link.sender.next(link.now)) << "and refused";
  link.run(300 * ms);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.counts(TrafficClass::critical).lost, 0U);
}

TEST(Peers, ARemovedStreamLeavesNothingBehind) {
  LinkPair link;
  StreamRule rule = rule_of(TrafficClass::critical);
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(10 * ms);
  link.offer(1, 2);
  link.sender.remove_stream(1);
  link.run(3000 * ms);
  EXPECT_EQ(link.sent.size(), 1U);
  const auto counts = link.counts(TrafficClass::critical);
  EXPECT_EQ(counts.lost, 1U);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::removed)], 1U);
}

TEST(Peers, AcknowledgementsAreFewAndStopWithTheTraffic) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::high));
  std::uint64_t sequence = 0;
  int step = 0;
  link.run(10000 * ms, [&] {
    if (step++ % 20 == 0) link.offer(1, ++sequence);
  });
  EXPECT_LE(link.acknowledgements, 201) << "20 a second for 50 samples a second";
  link.acknowledgements = 0;
  link.run(10000 * ms);
  EXPECT_LE(link.acknowledgements, 11);
  EXPECT_GE(link.acknowledgements, 9);
}

}  // namespace
}  // namespace tocsin::router
