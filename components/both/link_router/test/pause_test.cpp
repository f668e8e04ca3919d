// SPDX-License-Identifier: Apache-2.0
// The gate.
#include "link_pair.hpp"

namespace tocsin::router {
namespace {

using Sequences = std::vector<std::uint64_t>;

/// Stream 1 drops what is written during a pause, stream 2 keeps the newest.
void add_pausable(LinkPair& link) {
  StreamRule drops = rule_of(TrafficClass::low);
  drops.while_paused = WhilePaused::drop;
  StreamRule keeps = rule_of(TrafficClass::low);
  keeps.while_paused = WhilePaused::latest;
  link.add(1, drops);
  link.add(2, keeps);
}

TEST(Pause, WhatIsPausedIsSilentAndTheNewestFollows) {
  LinkPair link;
  add_pausable(link);
  link.add(3, rule_of(TrafficClass::critical));
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
  const auto counts = link.counts(TrafficClass::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::paused)], 5U);
}

/// A pause begins, and takes a sample that lives for a second.
void hold_a_sample(LinkPair& link) {
  StreamRule rule = rule_of(TrafficClass::low);
  rule.while_paused = WhilePaused::latest;
  rule.lifespan = 1000 * ms;
  link.add(1, rule);
  link.sender.set_paused(true, link.now);
  link.offer(1, 1);
}

TEST(Pause, WhatOutlivedThePauseOnlyByAgeIsNotSent) {
  LinkPair link;
  hold_a_sample(link);
  link.run(1001 * ms);
  link.sender.set_paused(false, link.now);
  link.run(100 * ms);
  EXPECT_TRUE(link.sent.empty());
  const auto counts = link.counts(TrafficClass::low);
  EXPECT_EQ(counts.dropped[static_cast<std::size_t>(DropReason::expired)], 1U);
}

/// Of a sample that was held for 600 ms of its 1000, on a link where small samples lately took 10
/// or 510 ms.
std::size_t sent_after_a_hold(unsigned vehicles) {
  LinkPair link;
  link.sender.set_vehicles(vehicles);
  link.add(2, rule_of(TrafficClass::critical));
  for (std::uint64_t i = 1; i <= 40; ++i) {
    link.delays[0] = i % 2 == 0 ? 10 * ms : 510 * ms;
    link.offer(2, i);
    link.run(600 * ms);
  }
  hold_a_sample(link);
  link.run(600 * ms);
  link.sender.set_paused(false, link.now);
  link.run(100 * ms);
  return link.count_sent(1);
}

TEST(Pause, WhatWouldArriveTooOldIsNotSentIntoSharedAir) {
  EXPECT_EQ(sent_after_a_hold(1), 1U);
  EXPECT_EQ(sent_after_a_hold(20), 0U);
}

TEST(Pause, APauseTakesWhatWaits) {
  LinkPair link;
  StreamRule rule = rule_of(TrafficClass::low);
  rule.while_paused = WhilePaused::drop;
  link.add(1, rule);
  link.offer(1, 1);
  link.sender.set_paused(true, link.now);
  link.run(100 * ms);
  EXPECT_TRUE(link.sent.empty());
}

TEST(Pause, RepairsOfAPausedStreamWait) {
  LinkPair link;
  StreamRule rule = rule_of(TrafficClass::high);
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

}  // namespace
}  // namespace tocsin::router
