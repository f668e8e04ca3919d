// SPDX-License-Identifier: Apache-2.0
// What a policy does with gaps, hostile samples and hostile clocks.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "policy_feed.hpp"

namespace tocsin::decision {
namespace {

using std::chrono::seconds;

TEST(Policy, ResumesAtTheDeadlineWhenSamplesStop) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  const Time paused = sut.now;
  EXPECT_FALSE(sut.policy->on_deadline(paused + seconds(180) - Duration{1}).changed);
  const Evidence evidence = sut.policy->on_deadline(paused + seconds(180));
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::forced_resume_time);
  EXPECT_FALSE(evidence.deadline.has_value());
}

TEST(Policy, ResumesByTimeOnALateSample) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  sut.now += seconds(179);
  EXPECT_EQ(sut(20).reason, Reason::forced_resume_time);
}

TEST(Policy, IgnoresADeadlineWhileActive) {
  const auto sut = make_policy(params_for("tocp"));
  const Evidence evidence = sut->on_deadline(t0);
  EXPECT_FALSE(evidence.changed);
  EXPECT_EQ(evidence.state, State::active);
}

TEST(Policy, DoesNotCountNanAsEvidence) {
  for (const char* name : {"threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief"}) {
    Feed sut(params_for(name));
    for (const double x : {double(NAN), double(INFINITY), double(-INFINITY)}) {
      const Evidence evidence = sut(x);
      EXPECT_EQ(evidence.reason, Reason::no_measurement);
      EXPECT_EQ(evidence.state, State::active);
    }
    sut(20);
    EXPECT_EQ(sut(NAN).state, State::passive) << name;
  }
}

TEST(Policy, CountsSamplesWithoutMeasurementInThePause) {
  Feed sut(params_for("tocp_dsp"));
  sut(20);
  for (int k = 1; k < 30; ++k) EXPECT_EQ(sut(NAN).age, k);
  EXPECT_EQ(sut(NAN).reason, Reason::forced_resume_samples);
}

TEST(Policy, DoesNotUseAStaleSample) {
  Feed sut(params_for("tocp"));
  sut(85);
  const Evidence evidence = sut.policy->on_sample({t0, 0}, sut.now);
  EXPECT_EQ(evidence.reason, Reason::stale_sample);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_TRUE(std::isnan(evidence.sample));
}

TEST(Policy, RecoversFromAStampOfTheFuture) {
  Feed sut(params_for("tocp"));
  sut.policy->on_sample({Time::max(), 85}, sut.now);
  EXPECT_EQ(sut(20).reason, Reason::cusum_alarm);
}

TEST(Policy, GoesOnWhenTheClockIsSetBack) {
  Feed sut(params_for("tocp"));
  sut(85);
  sut.now -= seconds(500);
  EXPECT_EQ(sut(20).reason, Reason::cusum_alarm);
  sut.now -= seconds(500);
  const Evidence evidence = sut(20);
  EXPECT_EQ(evidence.deadline, sut.now + seconds(180));
  EXPECT_TRUE(sut.policy->on_deadline(sut.now + seconds(180)).changed);
}

TEST(Policy, VoidsOldEvidenceAfterAGap) {
  Feed sut(params_for("tocp"));
  EXPECT_GT(sut(50).statistic, 3);
  sut.now += seconds(60);
  EXPECT_LT(sut(50).statistic, 4);
  EXPECT_EQ(sut(50).reason, Reason::cusum_alarm);
}

TEST(Policy, KeepsEvidenceAcrossAShorterGap) {
  Feed sut(params_for("tocp"));
  sut(50);
  sut.now += seconds(59);
  EXPECT_EQ(sut(50).reason, Reason::cusum_alarm);
}

TEST(Policy, BeliefFallsBackToTheLongRunAfterAGap) {
  Feed sut(params_for("belief"));
  sut(85);
  sut.now += seconds(100);
  EXPECT_NEAR(sut(NAN).statistic, 20 / 140.0, 1e-9);
}

/// Longest run of silence, in samples and in clock steps forward, on hostile input.
TEST(Policy, IsNeverSilentBeyondItsLimits) {
  std::mt19937 random(20190621);  // NOLINT: a fixed seed is the point
  for (const char* name : policy_names) {
    PolicyParams params = params_for(name);
    params.th_max_samples = params.fixed_pause_samples = 12;
    params.th_max_s = 20;
    const auto sut = make_policy(params);
    Time now = t0;
    Duration silent{};
    for (int i = 0; i < 50000; ++i) {
      const Duration step =
          seconds(int(random() % 4)) - (random() % 20 == 0 ? seconds(900) : seconds(0));
      now += step;
      const double x = random() % 5 == 0 ? NAN : double(random() % 140) - 20;
      const bool was_passive = sut->state() == State::passive;
      const Evidence evidence = random() % 10 == 0
                                    ? sut->on_deadline(now)
                                    : sut->on_sample({now - seconds(int(random() % 3)), x}, now);
      if (was_passive) silent += std::max(step, Duration{});
      if (evidence.state == State::active) {
        silent = Duration{};
        continue;
      }
      ASSERT_LT(evidence.age, 12) << name;
      ASSERT_LT(silent, seconds(20)) << name;
      ASSERT_TRUE(evidence.deadline);
      ASSERT_LE(*evidence.deadline, now + seconds(20)) << name;
    }
  }
}

}  // namespace
}  // namespace tocsin::decision
