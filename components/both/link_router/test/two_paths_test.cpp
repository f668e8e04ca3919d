// SPDX-License-Identifier: Apache-2.0
// Which path a sample takes, and what it costs when one ends.
#include <algorithm>

#include "link_pair.hpp"

namespace tocsin::router {
namespace {

class TwoPaths : public ::testing::Test {
 protected:
  explicit TwoPaths(const LinkRouterParams& params = {}) : link(params) { link.add_path(); }
  StreamRule rule_with(PathUse paths, TrafficClass traffic_class = TrafficClass::critical) {
    StreamRule rule = rule_of(traffic_class);
    rule.paths = paths;
    return rule;
  }
  /// A sample of stream 1 each 100 ms.
  void play(Duration length) {
    for (const Time end = link.now + length; link.now < end;) {
      offered_[++sequence_] = link.now;
      link.offer(1, sequence_);
      link.run(100 * ms);
    }
  }
  [[nodiscard]] long count_by(PathIndex path, std::size_t from = 0) const {
    return std::count_if(link.sent.begin() + static_cast<long>(from), link.sent.end(),
                         [path](const Transmission& one) { return one.path == path; });
  }
  LinkPair link;
  std::uint64_t sequence_ = 0;
  std::map<std::uint64_t, Time> offered_;
};

TEST_F(TwoPaths, WhatIsSentGoesByTheFirstAndOneASecondByTheOtherToo) {
  link.add(1, rule_with(PathUse::repair));
  play(5000 * ms);
  EXPECT_EQ(count_by(0), 50);
  EXPECT_EQ(count_by(1), 5);
  EXPECT_EQ(link.delivered[1].size(), 50U) << "each once";
  EXPECT_EQ(link.counts(TrafficClass::critical).delivered, 50U);
  EXPECT_EQ(link.counts(TrafficClass::critical).repaired, 0U);
}

TEST_F(TwoPaths, ARepairGoesByThePathThatTheLastTransmissionDidNotTake) {
  link.add(1, rule_with(PathUse::repair));
  play(1000 * ms);
  const std::size_t before = link.sent.size();
  link.loses = [&](const Transmission& one) { return one.path == 0; };
  play(100 * ms);
  link.run(100 * ms);
  ASSERT_GE(link.sent.size(), before + 2);
  EXPECT_EQ(link.sent[before].path, 0);
  EXPECT_EQ(link.sent[before + 1].path, 1);
  EXPECT_EQ(link.delivered[1].size(), 11U);
}

TEST_F(TwoPaths, AClassOfTheBestPathAloneIsRepairedThere) {
  link.add(1, rule_with(PathUse::best));
  play(1050 * ms);
  const std::size_t before = link.sent.size();
  link.loses = [&](const Transmission& one) { return !one.repair; };
  link.offer(1, ++sequence_);
  link.run(200 * ms);
  ASSERT_GE(link.sent.size(), before + 2);
  EXPECT_EQ(link.sent[before + 1].path, 0);
}

TEST_F(TwoPaths, APathThatDiesCostsNoSampleAndLateOnesWithinARepairOnly) {
  link.add(1, rule_with(PathUse::repair));
  play(3000 * ms);
  for (const PathIndex dies : {PathIndex{0}, PathIndex{1}}) {
    link.dead_paths[dies] = true;
    const std::size_t before = link.delivered[1].size();
    play(5000 * ms);
    EXPECT_EQ(link.delivered[1].size(), before + 50) << int{dies};
    EXPECT_EQ(link.counts(TrafficClass::critical).late, 0U);
    const auto state = link.sender.state(link.now);
    EXPECT_TRUE(state.paths[dies].silent);
    EXPECT_TRUE(state.paths[other_path(dies)].chosen);
    EXPECT_EQ(state.live_peers, 1U);
    link.dead_paths[dies] = false;
    play(3000 * ms);
    EXPECT_FALSE(link.sender.state(link.now).paths[dies].silent) << "found again by one a second";
  }
}

TEST_F(TwoPaths, BulkGoesOnByTheOtherPathWithinASecond) {
  link.add(1, rule_with(PathUse::best, TrafficClass::low));
  learn_capacity(link, 1);
  link.dead_paths[0] = true;
  const std::size_t before = link.delivered[1].size();
  for (std::uint64_t i = 100; i < 120; ++i) {
    link.offer(1, i, picture_bytes);
    link.run(150 * ms);
  }
  EXPECT_GE(link.delivered[1].size(), before + 12);
}

TEST_F(TwoPaths, WhatAdaptsIsSmallFromTheFirstSampleOnThatGoesByASlowerPath) {
  StreamRule rule = rule_with(PathUse::best, TrafficClass::low);
  rule.adaptive = true;
  link.add(1, rule);
  learn_capacity(link, 1);
  ASSERT_GT(link.sender.state(link.now).scale, 0.9);
  link.dead_paths[0] = true;
  for (int i = 0; i < 10 && link.sender.state(link.now).paths[0].chosen; ++i) {
    link.offer(90, 100 + static_cast<std::uint64_t>(i));
    link.offer(1, 100 + static_cast<std::uint64_t>(i), picture_bytes);
    link.run(50 * ms);
  }
  ASSERT_TRUE(link.sender.state(link.now).paths[1].chosen);
  link.run(100 * ms);
  EXPECT_LT(link.sender.state(link.now).scale, 0.6) << "half of 100 kB/s";
}

TEST_F(TwoPaths, FirstCopiesGoByBothWhileTheBetterIsPoor) {
  link.add(1, rule_with(PathUse::both));
  play(1000 * ms);
  const std::size_t before = link.sent.size();
  std::uint64_t count = 0;
  link.loses = [&](const Transmission&) { return ++count % 4 == 0; };
  play(10000 * ms);
  EXPECT_GE(count_by(1, before), 60) << "not before the loss is known";
  EXPECT_GE(link.delivered[1].size(), 108U);
}

TEST_F(TwoPaths, ThePathThatIsWorseIsLeftAfterThreeSecondsAndForGood) {
  link.add(1, rule_with(PathUse::best));
  link.delays[0] = 60 * ms;
  play(2500 * ms);
  EXPECT_TRUE(link.sender.state(link.now).paths[0].chosen);
  play(3000 * ms);
  EXPECT_TRUE(link.sender.state(link.now).paths[1].chosen);
  const auto delay = link.sender.state(link.now).paths[0].delay;
  ASSERT_TRUE(delay);
  EXPECT_NEAR(to_seconds(*delay), 0.058, 0.003) << "over the other, though no clock is known";
  play(10000 * ms);
  EXPECT_TRUE(link.sender.state(link.now).paths[1].chosen);
}

TEST_F(TwoPaths, PiecesByBothPathsMakeOneSample) {
  link.add(1, rule_with(PathUse::repair, TrafficClass::high));
  play(1000 * ms);
  std::map<std::uint8_t, int> tries;
  link.loses = [&](const Transmission& one) {
    return one.piece.count > 1 && one.piece.index == 3 && ++tries[3] == 1;
  };
  link.offer(1, ++sequence_, 10000);
  link.run(500 * ms);
  EXPECT_EQ(link.delivered[1].back(), sequence_);
  EXPECT_EQ(tries[3], 2);
  EXPECT_EQ(link.sent.back().path, 1) << "the piece that was lost";
}

TEST_F(TwoPaths, WhatADeadPathHasLostIsSentByTheOtherWhateverTheShareOfRepairs) {
  StreamRule rule = rule_with(PathUse::repair);
  rule.depth = 100;  // none is superseded
  link.add(1, rule);
  play(1000 * ms);
  link.dead_paths[0] = true;
  const std::size_t before = link.delivered[1].size();
  for (int i = 0; i < 200; ++i) {  // 50 kB/s: of an assumed 100 kB/s
    link.offer(1, ++sequence_);
    link.run(5 * ms);
  }
  link.run(100 * ms);
  EXPECT_EQ(link.delivered[1].size(), before + 200);
  EXPECT_LE(link.counts(TrafficClass::critical).late, 10U) << "those of the silence";
}

class MeteredPath : public TwoPaths {
 protected:
  static LinkRouterParams metered() {
    LinkRouterParams params;
    params.second_bytes_per_s = 20000;
    return params;
  }
  MeteredPath() : TwoPaths(metered()) {}
};

TEST_F(MeteredPath, BulkKeepsToWhatTheMeteredPathMayCarryAndSmallSamplesGoAtOnce) {
  link.add(1, rule_with(PathUse::repair));
  link.add(2, rule_with(PathUse::best, TrafficClass::low));
  play(1000 * ms);
  link.dead_paths[0] = true;
  play(2000 * ms);
  const std::size_t before = link.sent.size();
  const std::size_t small = link.delivered[1].size();
  for (std::uint64_t i = 1; i <= 100; ++i) {
    link.offer(2, i, picture_bytes);
    play(100 * ms);
  }
  std::size_t bytes = 0;
  for (std::size_t i = before; i < link.sent.size(); ++i) {
    if (link.sent[i].path == 1) bytes += link.sent[i].record.sample->cost.bytes;
  }
  EXPECT_EQ(link.delivered[1].size(), small + 100);
  EXPECT_LE(bytes, 10 * 20000U * 13 / 10) << "10 s";
}

}  // namespace
}  // namespace tocsin::router
