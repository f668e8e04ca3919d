// SPDX-License-Identifier: Apache-2.0
#include "simulation/campaign.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "radio_link.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

SeedOutcome broken_if(bool broken, std::uint64_t seed) {
  SeedOutcome checked;
  checked.seed = seed;
  checked.checks = 1;
  if (broken) checked.violations.push_back({1, "broken"});
  return checked;
}

TEST(Search, FindsTheFirstSeedThatFailsWithAnyNumberOfThreads) {
  for (const unsigned jobs : {1U, 2U, 7U}) {
    const auto result = search({1, 1000, jobs, true}, [](std::uint64_t seed) {
      return broken_if(seed >= 23 && seed % 2 == 1, seed);
    });
    ASSERT_EQ(result.broken.size(), 1U);
    EXPECT_EQ(result.broken[0].seed, 23U) << jobs;
    EXPECT_LT(result.runs, 40U);
  }
  const auto all =
      search({1, 30, 3, false}, [](std::uint64_t seed) { return broken_if(seed % 10 == 0, seed); });
  EXPECT_EQ(all.runs, 30U);
  EXPECT_EQ(all.checks, 30U);
  ASSERT_EQ(all.broken.size(), 3U);
  EXPECT_EQ(all.broken[0].seed, 10U);
  EXPECT_EQ(all.broken[2].seed, 30U);
}

TEST(Search, ThrowsWhatARunThrows) {
  EXPECT_THROW((void)search({1, 9, 2, true},
                            [](std::uint64_t) -> SeedOutcome { throw std::runtime_error("no"); }),
               std::runtime_error);
}

/// A link with a planted bug, in a world of its own with faults from the seed: its writer believes
/// that two packets in a row never overtake each other, and numbers nothing.
SeedOutcome run_planted(std::uint64_t seed) {
  Invariants invariants;
  Core core;
  core.observers = {&invariants};
  radio::ChannelParams params;
  params.mode = "bernoulli";
  RadioLink link(core, params, {{}, seed, 1});
  deployment::Deployment nothing;
  nothing.hosts.resize(1);
  SeedOutcome checked = broken_if(false, seed);
  checked.faults = random_faults(seed, nothing);
  for (const Fault& fault : checked.faults) {
    if (fault.kind != FaultKind::delay) continue;
    core.events.at(core.now + seconds(fault.at_s), [&] { link.faults(0).delay_s = 0.1; });
    core.events.at(core.now + seconds(fault.at_s + fault.for_s),
                   [&] { link.faults(0).delay_s = 0; });
  }
  TopicEnd from, to;
  from.lifespan_s = 5;
  for (std::uint64_t i = 1; i <= 700; ++i) {
    core.events.at(core.now + i * std::chrono::milliseconds(100), [&, i] {
      for (const std::uint64_t n : {2 * i, 2 * i + 1}) {
        link.send(radio::Direction::uplink, 100, [&, n, sent = core.now] {
          invariants.on_delivered({from, to, n, n, sent, sent, core.now, 64, nullptr});
        });
      }
    });
  }
  while (core.events.next() != never || link.next_event() != never) {
    core.now = std::min(core.events.next(), link.next_event());
    if (core.now > start_time + seconds(75)) break;  // the link reports for ever
    core.events.run(core.now);
    link.advance();
  }
  checked.violations = invariants.violations();
  return checked;
}

TEST(Search, FindsAPlantedBugAndItsSeedReplaysIt) {
  const auto result = search({1, 200, 2, true}, run_planted);
  ASSERT_EQ(result.broken.size(), 1U);
  const SeedOutcome& found = result.broken[0];
  const SeedOutcome again = run_planted(found.seed);
  ASSERT_FALSE(again.violations.empty());
  EXPECT_EQ(to_text(again), to_text(found));
  EXPECT_NE(to_text(found).find("out of order"), std::string::npos);
  for (std::uint64_t seed = 1; seed < found.seed; ++seed) {
    EXPECT_TRUE(run_planted(seed).violations.empty()) << seed;
  }
}

}  // namespace
}  // namespace tocsin::simulation
