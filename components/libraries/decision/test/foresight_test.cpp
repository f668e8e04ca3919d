// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "policy_feed.hpp"

namespace tocsin::decision {
namespace {

constexpr double good_qni = 85;
constexpr double bad_qni = 35;

/// So many seconds of one risk after the other.
Outlook outlook_of(const std::vector<std::pair<int, int>>& stretches) {
  Outlook outlook;
  for (const auto& [risk, s] : stretches) {
    for (int i = 0; i < s && outlook.size < Outlook::most; ++i) {
      outlook.risk_percent[outlook.size++] = static_cast<std::uint8_t>(risk);
    }
  }
  return outlook;
}

class ForesightTest : public ::testing::Test {
 protected:
  ForesightTest() { start(); }
  void start() { feed_ = std::make_unique<Feed>(params_); }
  Evidence see(const Outlook& outlook, double qni) {
    feed_->policy->foresee(outlook);
    return (*feed_)(qni);
  }
  PolicyParams params_ = params_for("foresight");
  std::unique_ptr<Feed> feed_;
};

TEST_F(ForesightTest, WaitsForTheGoodCornerThatComesInEightSeconds) {
  const auto evidence = see(outlook_of({{95, 8}, {2, 52}}), bad_qni);
  EXPECT_EQ(evidence.state, State::passive);
  EXPECT_EQ(evidence.reason, Reason::better_ahead);
  EXPECT_GT(evidence.statistic, 0.9) << "what is sent here is lost";
  EXPECT_NEAR(evidence.threshold, 0.08, 0.06) << "eight seconds";
}

TEST_F(ForesightTest, SendsOnWhereNoGoodCornerComes) {
  EXPECT_EQ(see(outlook_of({{99, 61}}), bad_qni).state, State::active);
  EXPECT_EQ(see(outlook_of({{99, 10}, {98, 51}}), bad_qni).state, State::active);
}

TEST_F(ForesightTest, SendsOnWhereTheLinkIsGood) {
  EXPECT_EQ(see(outlook_of({{2, 61}}), good_qni).state, State::active);
  EXPECT_EQ(see(outlook_of({{2, 10}, {98, 51}}), good_qni).state, State::active);
}

TEST_F(ForesightTest, ResumesAtTheCorner) {
  for (int ahead = 8; ahead > 0; --ahead) {
    ASSERT_EQ(see(outlook_of({{95, ahead}, {2, 60 - ahead}}), bad_qni).state, State::passive);
  }
  const auto evidence = see(outlook_of({{2, 61}}), good_qni);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::good_enough);
}

TEST_F(ForesightTest, AGoodSampleInABadPlaceIsTaken) {
  ASSERT_EQ(see(outlook_of({{60, 31}, {2, 30}}), bad_qni).state, State::passive);
  Evidence evidence;
  for (int i = 0; i < 5; ++i) evidence = see(outlook_of({{60, 30 - i}, {2, 31 + i}}), good_qni);
  EXPECT_EQ(evidence.state, State::active) << "the link is better than the map says";
}

TEST_F(ForesightTest, ALongWaitIsWorthItOnlyForALowCost) {
  const Outlook far = outlook_of({{98, 50}, {2, 11}});
  EXPECT_EQ(see(far, bad_qni).state, State::passive);
  params_.foresight_wait_cost = 0.05;
  start();
  EXPECT_EQ(see(far, bad_qni).state, State::active);
}

TEST_F(ForesightTest, WithoutAnOutlookItNeverPauses) {
  for (int i = 0; i < 50; ++i) EXPECT_EQ((*feed_)(bad_qni).state, State::active);
  ASSERT_EQ(see(outlook_of({{95, 8}, {2, 52}}), bad_qni).state, State::passive);
  const auto evidence = see({}, bad_qni);
  EXPECT_EQ(evidence.state, State::active);
  EXPECT_EQ(evidence.reason, Reason::no_outlook);
}

TEST_F(ForesightTest, WithoutAnOutlookItsFallbackDecides) {
  params_.foresight_fallback = FallbackKind::tocp_dsp;
  start();
  Evidence evidence;
  for (int i = 0; i < 10 && evidence.state == State::active; ++i) evidence = (*feed_)(bad_qni);
  EXPECT_EQ(evidence.state, State::passive);
  EXPECT_EQ(evidence.reason, Reason::cusum_alarm);
}

/// A map of another building: it promises a good link where there is none.
TEST_F(ForesightTest, DoesNotBelieveAMapThatIsWrongForLong) {
  int passive = 0;
  for (int i = 0; i < 100; ++i) {
    passive += see(outlook_of({{1, 61}}), bad_qni).state == State::passive ? 1 : 0;
  }
  EXPECT_LT(passive, 12);
  EXPECT_EQ(feed_->policy->state(), State::active);
}

TEST_F(ForesightTest, ASampleThatIsNoneChangesNothing) {
  ASSERT_EQ(see(outlook_of({{95, 8}, {2, 52}}), bad_qni).state, State::passive);
  const auto evidence =
      see(outlook_of({{95, 7}, {2, 53}}), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(evidence.state, State::passive);
}

TEST_F(ForesightTest, IsNeverSilentBeyondItsLimits) {
  params_.th_max_samples = 5;
  start();
  int in_a_row = 0;
  for (int i = 0; i < 100; ++i) {
    const auto evidence = see(outlook_of({{95, 8}, {2, 52}}), bad_qni);
    in_a_row = evidence.state == State::passive ? in_a_row + 1 : 0;
    ASSERT_LE(in_a_row, 5);
  }
}

}  // namespace
}  // namespace tocsin::decision
