// SPDX-License-Identifier: Apache-2.0
// What is sent again, when, and how often.
#include <set>

#include "link_pair.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;

TEST(Repair, RepairsALostSampleAfterTheFirstWait) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.dead = true;
  link.offer(1, 1);
  link.run(seconds(LinkRouterParams{}.repair_first_s));
  EXPECT_EQ(link.sent.size(), 1U);
  link.dead = false;
  link.run(20 * ms);
  ASSERT_EQ(link.sent.size(), 2U);
  EXPECT_TRUE(link.sent[1].repair);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  link.run(200 * ms);
  EXPECT_EQ(link.counts(TrafficClass::critical).repaired, 1U);
  EXPECT_EQ(link.counts(TrafficClass::critical).repairs, 1U);
}

TEST(Repair, ASampleOfClassLowIsSentAgainWhenALaterOneTellsOfItsLossTwiceAtMost) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  link.add(2, rule_of(TrafficClass::low));
  link.loses = [](const Transmission& one) { return one.stream == 1; };
  link.offer(1, 1);
  for (std::uint64_t i = 1; i <= 20; ++i) {
    link.offer(2, i);
    link.run(100 * ms);
  }
  EXPECT_EQ(link.count_sent(1), 3U);
  EXPECT_EQ(link.counts(TrafficClass::low).lost, 1U);
}

TEST(Repair, ASampleOfClassLowThatANewerFollowedIsNotSentAgain) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  link.loses = [](const Transmission& one) { return one.sample.origin.sequence == 1; };
  link.offer(1, 1);
  link.run(10 * ms);
  link.offer(1, 2);
  link.run(500 * ms);
  EXPECT_EQ(link.count_sent(1), 2U);
  EXPECT_EQ(link.delivered[1], (Sequences{2}));
}

TEST(Repair, BacksOffWhileNothingIsAcknowledged) {
  LinkPair link;
  StreamRule rule = rule_of(TrafficClass::critical);
  rule.durable = true;
  link.add(1, rule);
  link.dead = true;
  link.offer(1, 1);
  link.run(330 * ms);
  EXPECT_EQ(link.sent.size(), 3U) << "at 0, 70, 175 ms; next at 332.5 ms";
  link.run(4670 * ms);
  EXPECT_LE(link.sent.size(), 15U) << "then twice a second";
  EXPECT_GE(link.sent.size(), 12U);
}

TEST(Repair, GivesUpASampleWithoutALifespanAfterABoundUnlessItIsDurable) {
  LinkPair link;
  StreamRule durable = rule_of(TrafficClass::critical);
  durable.durable = true;
  link.add(1, rule_of(TrafficClass::critical));
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

/// Transmissions of 50 samples on a link whose way takes 150 ms, which is longer than the first
/// wait, and of which nothing is lost.
std::size_t sent_for_50(unsigned vehicles) {
  LinkRouterParams params;
  params.vehicles = static_cast<int>(vehicles);
  LinkPair link(params);
  link.delays[0] = 150 * ms;
  link.add(1, rule_of(TrafficClass::critical));
  for (std::uint64_t i = 1; i <= 50; ++i) {
    link.offer(1, i);
    link.run(400 * ms);
  }
  EXPECT_EQ(link.delivered[1].size(), 50U);
  return link.count_sent(1);
}

TEST(Repair, NothingIsSentAgainBeforeItsAcknowledgementIsDueWhereOthersShareTheAir) {
  EXPECT_GE(sent_for_50(1), 95U);
  for (const unsigned vehicles : {2U, 20U}) EXPECT_LE(sent_for_50(vehicles), 60U);
}

TEST(Repair, AcknowledgementsAreRarerWhereSmallSamplesWaitForSharedAir) {
  for (const unsigned vehicles : {1U, 20U}) {
    LinkPair link;
    link.sender.set_vehicles(vehicles);
    link.add(1, rule_of(TrafficClass::critical));
    std::uint64_t sent = 0;
    const auto cross = [&](Duration delay) {
      link.delays[0] = delay;
      link.offer(1, ++sent);
      link.run(500 * ms);
    };
    for (int i = 0; i < 20; ++i) cross(2 * ms);
    EXPECT_EQ(link.sender.acknowledgement_period(), acknowledgement_period);
    for (int i = 0; i < 20; ++i) cross(i % 2 == 0 ? 150 * ms : 350 * ms);
    EXPECT_EQ(link.sender.acknowledgement_period(),
              vehicles == 1 ? acknowledgement_period : acknowledgement_period_busy);
    for (int i = 0; i < 60; ++i) cross(2 * ms);
    EXPECT_EQ(link.sender.acknowledgement_period(), acknowledgement_period) << "it is calm again";
  }
}

std::size_t repairs_of_a_dead_link(unsigned vehicles) {
  constexpr StreamId streams = 60;
  LinkPair link;
  link.sender.set_vehicles(vehicles);
  StreamRule rule = rule_of(TrafficClass::critical);
  rule.durable = true;
  for (StreamId stream = 1; stream <= streams; ++stream) link.add(stream, rule);
  link.dead = true;
  for (StreamId stream = 1; stream <= streams; ++stream) link.offer(stream, 1);
  link.run(10'000 * ms);
  return link.sent.size() - streams;
}

TEST(Repair, AllWhoShareTheAirHaveOneShareOfItForRepairs) {
  const std::size_t alone = repairs_of_a_dead_link(1);
  const std::size_t of_twenty = repairs_of_a_dead_link(20);
  EXPECT_LT(of_twenty, alone / 5);
  EXPECT_GT(of_twenty, 10U) << "the link's return is found all the same";
  EXPECT_EQ(repairs_of_a_dead_link(0), alone);
  EXPECT_GE(repairs_of_a_dead_link(4'000'000), 10U) << "whatever is told";
}

TEST(Repair, LostAcknowledgementsCostARepairAndNoSecondDelivery) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.acknowledgements_lost = true;
  link.offer(1, 1);
  link.run(60 * ms);
  link.acknowledgements_lost = false;
  link.run(300 * ms);
  EXPECT_EQ(link.sent.size(), 2U);
  EXPECT_EQ(link.delivered[1], (Sequences{1}));
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 1U);
}

TEST(Repair, AFreshSampleCrossesWithinASecondOfTheLinksReturn) {
  for (const int dead_s : {1, 5, 30}) {
    LinkPair link;
    link.add(1, rule_of(TrafficClass::critical));
    link.add(2, rule_of(TrafficClass::low));
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

TEST(Repair, ADeadLinkGetsOnlyWhatCouldFindItAlive) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::low));
  learn_capacity(link, 1);
  link.dead = true;
  const std::size_t before = link.sent.size();
  for (std::uint64_t sequence = 100; sequence < 180; ++sequence) {
    link.offer(1, sequence, picture_bytes);
    link.run(125 * ms);
  }
  EXPECT_EQ(link.sender.state(link.now).silent_peers, 1U);
  std::set<Time> probes;  // pictures, or pieces of them
  for (std::size_t i = before; i < link.sent.size(); ++i) probes.insert(link.sent[i].record.sent);
  EXPECT_LE(probes.size(), 26U) << "10 s: about two a second";
  EXPECT_GE(probes.size(), 15U);
}

TEST(Repair, LateIsCountedFromTheOffer) {
  LinkPair link;
  link.add(1, rule_of(TrafficClass::critical));
  link.offer(1, 1);
  link.run(200 * ms);
  link.dead = true;
  link.offer(1, 2);
  link.run(260 * ms);
  link.dead = false;
  link.run(500 * ms);
  const auto counts = link.counts(TrafficClass::critical);
  EXPECT_EQ(counts.delivered, 2U);
  EXPECT_EQ(counts.late, 1U);
}

}  // namespace
}  // namespace tocsin::router
