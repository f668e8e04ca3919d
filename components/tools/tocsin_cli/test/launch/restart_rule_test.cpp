// SPDX-License-Identifier: Apache-2.0
#include "restart_rule.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace tocsin::cli {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Kind = RestartDecision::Kind;

constexpr Ending killed{true, 9};
constexpr Ending aborted{true, 6};
constexpr Ending failed{false, 3};
constexpr Ending ended_by_watchdog{false, 75};
const Time t0{seconds(1000)};

deployment::RestartPolicy policy(int limit = 20) {
  deployment::RestartPolicy p;
  p.backoff_s = 0.2;
  p.max_backoff_s = 5;
  p.limit = limit;
  return p;
}

TEST(RestartRule, FinishesWhenTheProcessEndsWell) {
  RestartRule sut(policy());
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit({false, 0}, t0).kind, Kind::finished);
}

TEST(RestartRule, RestartsWhatWasKilledAfterTheBackoff) {
  RestartRule sut(policy());
  sut.on_start(t0);
  const RestartDecision decision = sut.on_exit(killed, t0);
  EXPECT_EQ(decision.kind, Kind::restart);
  EXPECT_EQ(decision.delay, milliseconds(200));
}

TEST(RestartRule, RestartsAtOnceWhatWasUpForFiveSecondsAndDoesNotKeepDying) {
  RestartRule sut(policy());
  sut.on_start(t0);
  const Time death = t0 + seconds(5);
  EXPECT_EQ(sut.on_exit(killed, death).delay, milliseconds(0));
  sut.on_start(death);
  EXPECT_EQ(sut.on_exit(killed, death + seconds(60) - milliseconds(1)).delay, milliseconds(400));
  EXPECT_EQ(sut.on_exit(killed, death + seconds(120)).delay, milliseconds(0));
}

TEST(RestartRule, DoublesTheBackoffUpToItsMaximum) {
  RestartRule sut(policy());
  sut.on_start(t0);
  for (const int expected_ms : {200, 400, 800, 1600, 3200, 5000, 5000}) {
    EXPECT_EQ(sut.on_exit(aborted, t0).delay, milliseconds(expected_ms));
  }
}

TEST(RestartRule, ForgetsARestartAfterAMinute) {
  RestartRule sut(policy());
  sut.on_start(t0);
  (void)sut.on_exit(killed, t0);
  sut.on_start(t0 + seconds(59));
  EXPECT_EQ(sut.on_exit(killed, t0 + seconds(60) - milliseconds(1)).delay, milliseconds(400));
  sut.on_start(t0 + seconds(120));
  EXPECT_EQ(sut.on_exit(killed, t0 + seconds(120)).delay, milliseconds(200));
}

TEST(RestartRule, GivesUpWhatEndsItselfAfterTheLimitWithinAMinute) {
  RestartRule sut(policy(2));
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit(failed, t0).kind, Kind::restart);
  EXPECT_EQ(sut.on_exit(failed, t0 + seconds(1)).kind, Kind::restart);
  const RestartDecision decision = sut.on_exit(failed, t0 + seconds(59));
  EXPECT_EQ(decision.kind, Kind::too_often);
  EXPECT_EQ(decision.exit_code, 1);
}

TEST(RestartRule, NeverGivesUpWhatWasUpAndIsEndedFromOutside) {
  for (const Ending& ending : {killed, aborted, ended_by_watchdog}) {
    RestartRule sut(policy(2));
    sut.on_start(t0);
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(sut.on_exit(ending, t0 + seconds(5 + i)).kind, Kind::restart) << i;
    }
    EXPECT_EQ(sut.on_exit(ending, t0 + seconds(105)).delay, seconds(5)) << "the longest wait";
  }
}

TEST(RestartRule, GivesUpWhatASignalEndsBeforeItWasEverUp) {
  RestartRule sut(policy(2));
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit(aborted, t0).kind, Kind::restart);
  EXPECT_EQ(sut.on_exit(aborted, t0).kind, Kind::restart);
  EXPECT_EQ(sut.on_exit(aborted, t0).kind, Kind::too_often);
}

TEST(RestartRule, DoesNotGiveUpWhenTheDeathsAreFarApart) {
  RestartRule sut(policy(2));
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit(killed, t0).kind, Kind::restart);
  EXPECT_EQ(sut.on_exit(killed, t0 + seconds(1)).kind, Kind::restart);
  EXPECT_EQ(sut.on_exit(killed, t0 + seconds(60)).kind, Kind::restart);
}

TEST(RestartRule, NeverRestartsWithALimitOfZero) {
  RestartRule sut(policy(0));
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit(killed, t0 + seconds(5)).kind, Kind::too_often);
}

TEST(RestartRule, StopsWithTheCodeOfAConfigurationError) {
  RestartRule sut(policy());
  sut.on_start(t0);
  const RestartDecision decision = sut.on_exit({false, 2}, t0 + milliseconds(4999));
  EXPECT_EQ(decision.kind, Kind::refused);
  EXPECT_EQ(decision.exit_code, 2);
}

TEST(RestartRule, StopsWithOneWhenTheEnvironmentLacksSomething) {
  for (const int code : {1, 127}) {
    RestartRule sut(policy());
    sut.on_start(t0);
    const RestartDecision decision = sut.on_exit({false, code}, t0);
    EXPECT_EQ(decision.kind, Kind::refused) << code;
    EXPECT_EQ(decision.exit_code, 1) << code;
  }
}

TEST(RestartRule, RestartsAProcessThatWasUpWhateverItsCode) {
  RestartRule sut(policy());
  sut.on_start(t0);
  EXPECT_EQ(sut.on_exit({false, 2}, t0 + seconds(5)).kind, Kind::restart);
}

}  // namespace
}  // namespace tocsin::cli
