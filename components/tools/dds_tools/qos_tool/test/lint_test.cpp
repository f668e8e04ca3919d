// SPDX-License-Identifier: Apache-2.0
// Each trap on both sides of its threshold.
#include "lint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "foundation/error.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// One topic of one profile, on `way`.
LintInput one_topic(const QosProfile& profile, Way way = Way::direct) {
  LintInput input;
  input.profiles["p"] = profile;
  input.topics.push_back({"t", "p", way});
  return input;
}

std::vector<std::string> rules_of(const LintInput& input) {
  std::vector<std::string> rules;
  for (const Finding& one : lint(input)) rules.push_back(one.rule);
  return rules;
}

TEST(Lint, AProfileOfDefaultsIsInNoTrap) {
  EXPECT_THAT(rules_of(one_topic({})), IsEmpty());
  EXPECT_EQ(lint_text({}), "no known trap\n");
  EXPECT_THAT(lint({}), IsEmpty());
  EXPECT_THAT(rules_of({}), IsEmpty());
}

TEST(Lint, AStreamThatIsRepairedOverTheRadio) {
  LintInput input = one_topic({});
  input.topics[0].is_stream = true;
  EXPECT_THAT(rules_of(input), ElementsAre("reliable-stream"));
  input.profiles["p"].requested_reliability = RequestedReliability::best_effort;
  EXPECT_THAT(rules_of(input), IsEmpty());
}

TEST(Lint, AStreamInAClassThatTheRouterRepairs) {
  LintInput input = one_topic({}, Way::routed);
  input.topics[0].is_stream = true;
  EXPECT_THAT(rules_of(input), IsEmpty()) << "the host's QoS does not cross the radio";
  input.topics[0].traffic_class = TrafficClass::high;
  EXPECT_THAT(rules_of(input), ElementsAre("reliable-stream"));
}

TEST(LintStreams, TheTopicsOfAProfileAreJudgedAsStreams) {
  LintInput input = one_topic({}, Way::routed);
  input.topics[0].traffic_class = TrafficClass::high;
  EXPECT_THAT(rules_of(input), IsEmpty());
  mark_streams(input, {"p"}, "qos.yaml");
  EXPECT_THAT(rules_of(input), ElementsAre("reliable-stream"));
  EXPECT_EQ(input.topics.size(), 1U);
}

TEST(LintStreams, AProfileThatNoTopicUsesIsJudgedAsIfItsEndsStoodOnTheRadio) {
  LintInput input = one_topic({});
  input.profiles["pictures"] = {};
  EXPECT_THAT(rules_of(input), IsEmpty());
  mark_streams(input, {"pictures"}, "qos.yaml");
  const auto findings = lint(input);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].rule, "reliable-stream");
  EXPECT_EQ(findings[0].subject, "topic of profile pictures (pictures)");
}

TEST(LintStreams, AnUnknownProfileIsRefusedWithWhatIsLikeIt) {
  LintInput input;
  input.profiles["stream"] = {};
  try {
    mark_streams(input, {"steam"}, "qos.yaml");
    FAIL() << "an unknown profile";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "--stream: 'steam' is not a profile of qos.yaml; did you mean 'stream'?");
  }
}

TEST(Lint, TransientLocalWithKeepAll) {
  QosProfile profile;
  profile.history = History::keep_all;
  EXPECT_THAT(rules_of(one_topic(profile)), IsEmpty());
  profile.durability = Durability::transient_local;
  EXPECT_THAT(rules_of(one_topic(profile, Way::host)), ElementsAre("keeps-everything"));
}

TEST(Lint, ALeaseThatIsShorterThanTheOutages) {
  QosProfile profile;
  profile.liveliness_lease_s = 9.9;
  LintInput input = one_topic(profile);
  input.outage_s = 10;
  EXPECT_THAT(rules_of(input), ElementsAre("short-lease"));
  input.outage_s = 9.9;
  EXPECT_THAT(rules_of(input), IsEmpty());
  input.outage_s = 10;
  input.topics[0].way = Way::host;
  EXPECT_THAT(rules_of(input), IsEmpty());
}

TEST(Lint, AHeartbeatThatIsSlowForWhatIsRepaired) {
  QosProfile profile;
  profile.heartbeat_period_s = 1;
  EXPECT_THAT(rules_of(one_topic(profile)), IsEmpty());
  profile.heartbeat_period_s = 3;
  EXPECT_THAT(rules_of(one_topic(profile)), ElementsAre("slow-heartbeat"));
  profile.requested_reliability = RequestedReliability::best_effort;
  EXPECT_THAT(rules_of(one_topic(profile)), IsEmpty());
  QosProfile brief;
  brief.lifespan_s = 0.3;
  EXPECT_THAT(rules_of(one_topic(brief, Way::host)), ElementsAre("slow-heartbeat"))
      << "0.2 s is more than half of the lifespan";
  brief.lifespan_s = 0.4;
  EXPECT_THAT(rules_of(one_topic(brief, Way::host)), IsEmpty());
}

TEST(Lint, ALifespanBetweenClocksThatDiffer) {
  QosProfile profile;
  profile.lifespan_s = 5;
  LintInput input = one_topic(profile);
  EXPECT_THAT(rules_of(input), ElementsAre("foreign-clocks"));
  input.clock_offset_s = 0;
  EXPECT_THAT(rules_of(input), IsEmpty());
  EXPECT_THAT(rules_of(one_topic(profile, Way::routed)), IsEmpty())
      << "our readers do not compare clocks";
}

}  // namespace
}  // namespace tocsin::qos_tool
