// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/probe_window.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/parameters.hpp"

namespace tocsin::network {
namespace {

using std::chrono::milliseconds;

constexpr Time t0{std::chrono::hours{5}};
constexpr auto rtt = milliseconds{20};

/// Runs the window through [from, to) on its own deadlines. `answer(sequence)` says whether a
/// probe is answered, 20 ms after it was sent. Gives the last sample.
template <class Answer>
std::optional<ProbeSample> run(ProbeWindow& sut, Time from, Time to, Answer answer) {
  std::optional<ProbeSample> last;
  Time now = from;
  for (; now < to; now = std::max(now, sut.next_deadline())) {
    if (const auto sequence = sut.take_due(now)) {
      if (answer(*sequence)) (void)sut.on_reply(*sequence, now + rtt);
    }
    if (const auto sample = sut.take_sample(now)) last = sample;
  }
  return last;
}

const auto always = [](std::uint16_t) { return true; };
const auto never_answered = [](std::uint16_t) { return false; };

/// A window with one probe, sequence 0, sent at t0.
ProbeWindow probed_once(const ProbeParams& params = {}) {
  ProbeWindow sut(params);
  EXPECT_EQ(sut.take_due(t0), 0);
  return sut;
}

TEST(ProbeWindow, ProbesAtOnceThenEveryPeriod) {
  ProbeWindow sut(ProbeParams{});
  EXPECT_LT(sut.next_deadline(), t0);
  EXPECT_EQ(sut.take_due(t0), 0);
  EXPECT_EQ(sut.next_deadline(), t0 + milliseconds{300});
  EXPECT_EQ(sut.take_due(t0 + milliseconds{299}), std::nullopt);
  EXPECT_EQ(sut.take_due(t0 + milliseconds{300}), 1);
}

TEST(ProbeWindow, KeepsItsPhaseWhenWokenLate) {
  ProbeWindow sut = probed_once();
  EXPECT_EQ(sut.take_due(t0 + milliseconds{350}), 1);
  EXPECT_EQ(sut.next_deadline(), t0 + milliseconds{600});
}

TEST(ProbeWindow, SkipsMissedSlotsInsteadOfSendingABurst) {
  ProbeWindow sut = probed_once();
  const Time thawed = t0 + milliseconds{3150};
  EXPECT_EQ(sut.take_due(thawed), 1);
  EXPECT_EQ(sut.take_due(thawed), std::nullopt);
  EXPECT_EQ(sut.take_due(thawed + milliseconds{300}), 2);
}

TEST(ProbeWindow, ForgetsWhatWasSentAndGoesOnInItsPhase) {
  ProbeWindow sut(ProbeParams{});
  (void)run(sut, t0, t0 + seconds(10), never_answered);
  const Time next = sut.next_deadline();
  sut.forget();
  EXPECT_EQ(sut.next_deadline(), next);
  EXPECT_EQ(sut.on_reply(30, next), ReplyKind::unknown);
  const auto sample = run(sut, next, next + seconds(3), always);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 0);
  EXPECT_LT(sample->sent, 10);
}

TEST(ProbeWindow, GivesASampleEachSecondAndWakesForIt) {
  ProbeParams params;
  params.timeout_s = 0.5;
  ProbeWindow sut = probed_once(params);
  (void)sut.on_reply(0, t0 + rtt);
  for (int i = 1; i <= 3; ++i) (void)sut.take_due(t0 + i * milliseconds{300});
  EXPECT_EQ(sut.next_deadline(), t0 + milliseconds{1000});
  EXPECT_FALSE(sut.take_sample(t0 + milliseconds{999}));
  EXPECT_TRUE(sut.take_sample(t0 + milliseconds{1000}));
  EXPECT_FALSE(sut.take_sample(t0 + milliseconds{1999}));
  EXPECT_TRUE(sut.take_sample(t0 + milliseconds{2000}));
}

TEST(ProbeWindow, InventsNoSampleBeforeTheFirstProbeSettles) {
  ProbeWindow sut = probed_once();
  EXPECT_FALSE(sut.take_sample(t0 + milliseconds{1000}));  // a reply would still be in time
  ASSERT_TRUE(sut.take_sample(t0 + milliseconds{2000}));
}

TEST(ProbeWindow, CallsALinkWithoutAnyReplyHundredPercentLost) {
  ProbeWindow sut(ProbeParams{});
  const auto sample = run(sut, t0, t0 + milliseconds{8001}, never_answered);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 100.0);
  EXPECT_EQ(sample->sent, 20);
  EXPECT_EQ(sample->received, 0);
  EXPECT_FALSE(sample->rtt);
}

TEST(ProbeWindow, CallsALinkWithEveryReplyFreeOfLoss) {
  ProbeWindow sut(ProbeParams{});
  const auto sample = run(sut, t0, t0 + milliseconds{8001}, always);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 0.0);
  EXPECT_EQ(sample->sent, 20);
  EXPECT_EQ(sample->received, 20);
}

TEST(ProbeWindow, CountsEachLossAsItsShareOfTheWindow) {
  ProbeWindow sut(ProbeParams{});
  const auto sample =
      run(sut, t0, t0 + milliseconds{20001}, [](std::uint16_t s) { return s % 4 != 0; });
  ASSERT_TRUE(sample);
  EXPECT_DOUBLE_EQ(sample->per_percent, 25.0);
}

TEST(ProbeWindow, ForgetsWhatHasLeftTheWindow) {
  ProbeWindow sut(ProbeParams{});
  (void)run(sut, t0, t0 + milliseconds{8000}, never_answered);
  const auto sample = run(sut, t0 + milliseconds{8001}, t0 + milliseconds{15501}, always);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 0.0);
}

TEST(ProbeWindow, RisesGraduallyWhenTheLinkDies) {
  ProbeWindow sut(ProbeParams{});
  (void)run(sut, t0, t0 + milliseconds{9000}, always);
  const auto sample = run(sut, t0 + milliseconds{9000}, t0 + milliseconds{12001}, never_answered);
  ASSERT_TRUE(sample);
  // Probes at 9.0, 9.3, ... 10.8 s are older than 1 s at 12.0 s: 7 of 20.
  EXPECT_DOUBLE_EQ(sample->per_percent, 35.0);
}

TEST(ProbeWindow, CountsAProbeOnlyWhenItIsOlderThanTheTimeout) {
  ProbeWindow sut = probed_once();
  (void)sut.on_reply(0, t0 + rtt);
  (void)sut.take_due(t0 + milliseconds{300});
  (void)sut.on_reply(1, t0 + milliseconds{300} + rtt);
  const auto sample = sut.take_sample(t0 + milliseconds{1300});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->sent, 1);
  EXPECT_EQ(sample->received, 1);
}

TEST(ProbeWindow, AcceptsAReplyExactlyAtTheTimeout) {
  ProbeWindow sut = probed_once();
  EXPECT_EQ(sut.on_reply(0, t0 + milliseconds{1000}), ReplyKind::accepted);
}

TEST(ProbeWindow, CallsAReplyBeyondTheTimeoutLateAndTheProbeLost) {
  ProbeWindow sut = probed_once();
  EXPECT_EQ(sut.on_reply(0, t0 + milliseconds{1001}), ReplyKind::late);
  EXPECT_EQ(sut.totals().late, 1U);
  const auto sample = sut.take_sample(t0 + milliseconds{1002});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 100.0);
}

TEST(ProbeWindow, JudgesAReplyByItsArrivalNotByItsReading) {
  ProbeWindow sut = probed_once();
  ASSERT_TRUE(sut.take_sample(t0 + milliseconds{1500}));  // frozen meanwhile: counted as lost
  EXPECT_EQ(sut.on_reply(0, t0 + milliseconds{30}), ReplyKind::accepted);
  const auto sample = sut.take_sample(t0 + milliseconds{2500});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 0.0);
}

TEST(ProbeWindow, CountsADuplicateOnce) {
  ProbeWindow sut = probed_once();
  EXPECT_EQ(sut.on_reply(0, t0 + rtt), ReplyKind::accepted);
  EXPECT_EQ(sut.on_reply(0, t0 + 2 * rtt), ReplyKind::duplicate);
  EXPECT_EQ(sut.totals().duplicates, 1U);
  const auto sample = sut.take_sample(t0 + milliseconds{2000});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->received, 1);
  EXPECT_DOUBLE_EQ(sample->rtt->max_ms, 20.0);
}

TEST(ProbeWindow, IgnoresRepliesToProbesItNeverSent) {
  ProbeWindow sut = probed_once();
  EXPECT_EQ(sut.on_reply(1, t0 + rtt), ReplyKind::unknown);
  EXPECT_EQ(sut.on_reply(65535, t0 + rtt), ReplyKind::unknown);
  EXPECT_EQ(sut.totals().unknown, 2U);
}

TEST(ProbeWindow, CountsARefusedProbeAsLost) {
  ProbeWindow sut = probed_once();
  sut.on_send_error(0);
  const auto sample = sut.take_sample(t0 + milliseconds{2000});
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->per_percent, 100.0);
  EXPECT_EQ(sut.totals().send_errors, 1U);
  EXPECT_EQ(sut.on_reply(0, t0 + rtt), ReplyKind::unknown);
}

TEST(ProbeWindow, MeasuresRttFromTheInstantOfSending) {
  ProbeWindow sut = probed_once();
  sut.on_sent(0, t0 + milliseconds{5});
  (void)sut.on_reply(0, t0 + milliseconds{12});
  const auto sample = sut.take_sample(t0 + milliseconds{2000});
  ASSERT_TRUE(sample && sample->rtt);
  EXPECT_DOUBLE_EQ(sample->rtt->mean_ms, 7.0);
}

TEST(ProbeWindow, SummarisesRttOfTheAnsweredOnly) {
  ProbeWindow sut = probed_once();
  (void)sut.on_reply(0, t0 + milliseconds{10});
  (void)sut.take_due(t0 + milliseconds{300});
  (void)sut.on_reply(1, t0 + milliseconds{330});
  (void)sut.take_due(t0 + milliseconds{600});
  sut.on_send_error(2);
  const auto sample = sut.take_sample(t0 + milliseconds{2000});
  ASSERT_TRUE(sample && sample->rtt);
  EXPECT_DOUBLE_EQ(sample->rtt->min_ms, 10.0);
  EXPECT_DOUBLE_EQ(sample->rtt->mean_ms, 20.0);
  EXPECT_DOUBLE_EQ(sample->rtt->max_ms, 30.0);
}

TEST(ProbeWindow, TakesAReplyBeforeItsProbeAsZeroRtt) {
  ProbeWindow sut = probed_once();
  (void)sut.on_reply(0, t0 - milliseconds{1});
  const auto sample = sut.take_sample(t0 + milliseconds{2000});
  ASSERT_TRUE(sample && sample->rtt);
  EXPECT_EQ(sample->rtt->min_ms, 0.0);
}

TEST(ProbeWindow, SurvivesTheWrapOfTheSequenceNumber) {
  ProbeParams params;
  params.period_s = 0.02;
  params.window = 5;
  ProbeWindow sut(params);
  const auto sample = run(sut, t0, t0 + milliseconds{65530 * 20}, always);
  ASSERT_TRUE(sample);
  const auto wrapped = run(sut, t0 + milliseconds{65530 * 20}, t0 + milliseconds{65700 * 20},
                           [](std::uint16_t s) { return s % 5 != 0; });
  ASSERT_TRUE(wrapped);
  EXPECT_DOUBLE_EQ(wrapped->per_percent, 20.0);
  EXPECT_EQ(sut.totals().unknown, 0U);
}

TEST(ProbeWindow, FillsTheWindowThoughManyProbesArePending) {
  ProbeParams params;
  params.period_s = 0.02;
  params.window = 3;
  ProbeWindow sut(params);
  const auto sample = run(sut, t0, t0 + milliseconds{5001}, never_answered);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->sent, 3);
}

TEST(ProbeParams, RejectsAnEmptyWindow) {
  EXPECT_ANY_THROW((void)load_parameters<ProbeParams>(YAML::Load("window: 0"), "a", "b"));
  EXPECT_EQ(load_parameters<ProbeParams>(YAML::Load("window: 1"), "a", "b").window, 1);
}

TEST(ProbeWindow, AnotherWindowCountsFromTheNextSample) {
  ProbeWindow sut(ProbeParams{});
  const Time later = t0 + std::chrono::seconds{20};
  EXPECT_EQ(run(sut, t0, later, always)->sent, 20);
  ProbeParams shorter;
  shorter.window = 5;
  sut.set_limits(shorter);
  EXPECT_EQ(run(sut, later, later + std::chrono::seconds{5}, never_answered)->per_percent, 100);
  sut.set_limits({});
  const auto sample =
      run(sut, later + std::chrono::seconds{5}, later + std::chrono::seconds{30}, always);
  EXPECT_EQ(sample->sent, 20);
  EXPECT_EQ(sample->per_percent, 0);
}

TEST(ProbeWindow, AnotherTimeoutHoldsForProbesOnTheirWay) {
  ProbeWindow sut = probed_once();
  ProbeParams patient;
  patient.timeout_s = 2;
  sut.set_limits(patient);
  EXPECT_EQ(sut.on_reply(0, t0 + milliseconds{2000}), ReplyKind::accepted);
  ProbeWindow strict = probed_once();
  patient.timeout_s = 0.5;
  strict.set_limits(patient);
  EXPECT_EQ(strict.on_reply(0, t0 + milliseconds{501}), ReplyKind::late);
}

}  // namespace
}  // namespace tocsin::network
