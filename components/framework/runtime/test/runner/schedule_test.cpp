// SPDX-License-Identifier: Apache-2.0
// When components run next: periods, and phases of their own.
#include "runtime/detail/schedule.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <vector>

#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

const Time t0{seconds(1)};

TEST(Schedule, SkipsMissedPeriodsAndCountsThem) {
  Schedule sut;
  sut.repeat({seconds(0.1)});
  sut.begin_tick(t0);
  EXPECT_EQ(sut.due(), t0 + seconds(0.1));
  sut.begin_tick(t0 + seconds(0.35));
  EXPECT_EQ(sut.overruns, 2U);
  EXPECT_EQ(sut.due(), t0 + seconds(0.4)) << "late once is not late for ever";
}

TEST(Schedule, ATickThatComesJustBeforeTheNextPeriodHasMissedNone) {
  Schedule sut;
  sut.repeat({seconds(0.1)});
  sut.begin_tick(t0);
  sut.begin_tick(t0 + seconds(0.2) - Duration(1));
  EXPECT_EQ(sut.overruns, 0U);
  sut.begin_tick(t0 + seconds(0.3));
  EXPECT_EQ(sut.overruns, 1U);
}

TEST(Schedule, APeriodAskedForBeforeTheFirstTickCountsFromThatTick) {
  Schedule sut;
  sut.repeat({seconds(0.1)});
  EXPECT_EQ(sut.due(), never);
  sut.begin_tick(t0);
  EXPECT_EQ(sut.due(), t0 + seconds(0.1));
}

TEST(Schedule, APeriodAskedForWithinATickCountsFromIt) {
  Schedule sut;
  sut.begin_tick(t0);
  sut.repeat({seconds(0.1)});
  EXPECT_EQ(sut.due(), t0 + seconds(0.1));
  sut.begin_tick(t0 + seconds(0.1));
  EXPECT_EQ(sut.due(), t0 + seconds(0.2));
}

TEST(Schedule, AnotherPeriodReplacesTheOne) {
  Schedule sut;
  sut.begin_tick(t0);
  sut.repeat({seconds(0.1)});
  sut.repeat({seconds(0.5)});
  EXPECT_EQ(sut.due(), t0 + seconds(0.5));
}

TEST(Schedule, InputDoesNotMoveThePeriod) {
  Schedule sut;
  sut.repeat({seconds(0.1)});
  sut.begin_tick(t0);
  sut.begin_tick(t0 + seconds(0.05));
  EXPECT_EQ(sut.due(), t0 + seconds(0.1));
}

TEST(PeriodicInstants, AreAtTheirPhaseOfTheClock) {
  const PeriodicInstants sut{seconds(1), 0.25};
  EXPECT_EQ(sut.after(Time{seconds(10)}), Time{seconds(11.25)});
  EXPECT_EQ(sut.after(Time{seconds(11.25)}), Time{seconds(12.25)});
  EXPECT_EQ(sut.after(Time{seconds(11.26)}), Time{seconds(12.25)}) << "late";
  EXPECT_EQ(sut.after(Time{seconds(11.24)}), Time{seconds(12.25)}) << "early";
}

TEST(PeriodicInstants, TheNextIsHalfToOneAndAHalfPeriodsAway) {
  const PeriodicInstants sut{seconds(1), 0.25};
  EXPECT_EQ(sut.after(Time{seconds(10.75)}), Time{seconds(11.25)});
  EXPECT_EQ(sut.after(Time{seconds(10.75) + Duration(1)}), Time{seconds(12.25)});
  std::minstd_rand random(1);
  for (int i = 0; i < 10'000; ++i) {
    const Duration period(1 + random());
    const PeriodicInstants any{period, static_cast<double>(random() % 1000) / 1000};
    const Time now{Duration(static_cast<std::int64_t>(random()) * 1'000'003)};
    const Duration wait = any.after(now) - now;
    ASSERT_GE(wait, period / 2);
    ASSERT_LE(wait, period + period / 2 + Duration(1));
    ASSERT_EQ(any.after(any.after(now)) - any.after(now), period);
  }
}

TEST(PhaseOf, IsTheSameOnEveryComputer) {
  // FNV-1a and splitmix64, computed apart from this code.
  EXPECT_DOUBLE_EQ(phase_of(process_seed(1, "uxv", "drive"), "navigator"), 0.6081821767796157);
}

TEST(PhaseOf, DependsOnSeedHostProcessAndName) {
  std::set<double> phases;
  for (const int seed : {1, 2}) {
    for (const char* host : {"uxv", "gcs"}) {
      for (const char* process : {"link", "drive"}) {
        for (const char* name : {"gate", "control"}) {
          phases.insert(phase_of(process_seed(seed, host, process), name));
        }
      }
    }
  }
  EXPECT_EQ(phases.size(), 16U);
}

TEST(PhaseOf, IsUniformOverSeeds) {
  constexpr int seeds = 10'000;
  std::vector<int> tenths(10);
  for (int seed = 0; seed < seeds; ++seed) {
    const double phase = phase_of(process_seed(seed, "uxv", "link"), "gate");
    ASSERT_GE(phase, 0);
    ASSERT_LT(phase, 1);
    ++tenths[static_cast<std::size_t>(phase * 10)];
  }
  double chi_squared = 0;
  for (const int count : tenths) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chi_squared, 27.9) << "p 0.001 with 9 degrees of freedom";
}

/// Notes when it ticks.
class Ticker final : public Component {
 public:
  Ticker(Context& context, Duration period) : Component(context) { wake_every(period); }
  void tick(Time now) override { at.push_back(now); }
  std::vector<Time> at;
};

TEST(ComponentPhase, ComponentsOfOneProcessStartTogetherAndThenTickAtInstantsOfTheirOwn) {
  SimBus bus;
  Context first_context{bus, "first", Role::uxv};
  Context second_context{bus, "second", Role::uxv};
  Ticker first(first_context, seconds(1));
  Ticker second(second_context, seconds(1));
  bus.add(first);
  bus.add(second);
  bus.run_for(seconds(10));
  ASSERT_GE(first.at.size(), 10U);
  EXPECT_EQ(first.at[0], second.at[0]);
  for (std::size_t i = 1; i < std::min(first.at.size(), second.at.size()); ++i) {
    EXPECT_NE(first.at[i], second.at[i]);
    EXPECT_EQ(first.at[i] - first.at[1], second.at[i] - second.at[1]);
  }
}

TEST(ComponentPhase, OneThatIsRestartedTakesUpTheInstantsThatItHad) {
  SimBus bus;
  Context context{bus, "one", Role::uxv};
  Time before{};
  {
    Ticker sut(context, seconds(1));
    bus.add(sut);
    bus.run_for(seconds(5));
    before = sut.at.back();
  }
  SimBus later;
  later.run_for(seconds(7.77));
  Context again{later, "one", Role::uxv};
  Ticker sut(again, seconds(1));
  later.add(sut);
  later.run_for(seconds(5));
  EXPECT_EQ((sut.at.back() - before) % seconds(1), Duration::zero());
}

TEST(ComponentPhase, AnotherSeedOfTheRunGivesOtherInstants) {
  SimBus bus;
  Context one{bus, "one", Role::uxv};
  Context other = one;
  other.seed = process_seed(2, "uxv", "link");
  const Ticker first(one, seconds(1));
  const Ticker second(other, seconds(1));
  EXPECT_NE(first.next_instant(seconds(1), t0), second.next_instant(seconds(1), t0));
}

}  // namespace
}  // namespace tocsin
