// SPDX-License-Identifier: Apache-2.0
#include "matches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tocsin::qos_tool {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

End end(const std::string& name, const QosContract& qos, const std::string& type = "T") {
  return {name, type, qos};
}

QosContract with_deadline(double s) {
  QosContract qos;
  qos.deadline_s = s;
  return qos;
}

TEST(Pair, IsStoppedByPoliciesAndByTheType) {
  EXPECT_THAT((Pair{end("w", {}), end("r", {})}.stopped_by()), IsEmpty());
  EXPECT_THAT((Pair{end("w", with_deadline(2)), end("r", with_deadline(1))}.stopped_by()),
              ElementsAre("deadline"));
  EXPECT_THAT((Pair{end("w", {}), end("r", {}, "U")}.stopped_by()), ElementsAre("type"));
  EXPECT_THAT((Pair{end("w", {}, ""), end("r", {}, "U")}.stopped_by()), IsEmpty())
      << "a profile has no type";
}

TEST(Pair, OfAProfileRequestsWhatItsReadersDo) {
  QosProfile sensor;
  sensor.requested_reliability = RequestedReliability::best_effort;
  EXPECT_TRUE(writer_of("sensor", sensor).qos.reliable());
  EXPECT_FALSE(reader_of("sensor", sensor).qos.reliable());
}

TEST(MatchText, SaysWhichPolicyStopsWhomAndTheRule) {
  const auto pairs = pairs_of({end("w", with_deadline(2))},
                              {end("r", with_deadline(1)), end("s", with_deadline(2))});
  EXPECT_EQ(match_text(pairs, false),
            "w and r do not match, stopped by deadline\n"
            "  STOPS  deadline: offered 2 s, requested 1 s (offered at most as long as requested)\n"
            "w and s match\n");
  EXPECT_THAT(match_text(pairs, true),
              HasSubstr("  fits   ownership: offered shared, requested shared (the same kind"));
}

TEST(MatchText, SaysWhereFastDdsDepartsFromTheSpecification) {
  QosContract coherent;
  coherent.presentation.coherent = true;
  EXPECT_THAT(match_text({{end("w", {}), end("r", coherent)}}, false),
              AllOf(HasSubstr("stopped by presentation"), HasSubstr("two ends of it match")));
  EXPECT_THAT(match_text({{end("w", {}), end("r", {}, "U")}}, false),
              AllOf(HasSubstr("STOPS  type: the writer's is T, the reader's U"),
                    Not(HasSubstr("two ends of it match"))));
}

TEST(EndsOf, AreThoseOfTheTopicThatWriteOrRead) {
  GraphEnd writer{"rt/a", "T", "talker", {"1"}, true};
  GraphEnd reader{"rt/a", "T", "", {"2"}, false};
  GraphEnd other{"rt/b", "T", "talker", {"3"}, true};
  const std::vector<GraphEnd> all{writer, reader, other};
  ASSERT_EQ(ends_of(all, "rt/a", true).size(), 1U);
  EXPECT_EQ(ends_of(all, "rt/a", true)[0].name, "the writer in talker");
  EXPECT_EQ(ends_of(all, "rt/a", false)[0].name, "the reader in an unnamed participant");
}

/// The page of one pair that differs in one policy.
std::string page(const QosContract& offered, const QosContract& requested) {
  return match_text({{end("w", offered), end("r", requested)}}, false);
}

TEST(MatchText, ShowsControlCharactersOfOthersAsText) {
  QosContract strange;
  strange.partition = {"\x1b[31m"};
  EXPECT_THAT(page(strange, {}), AllOf(HasSubstr("\\x1b[31m"), Not(HasSubstr("\x1b"))));
}

}  // namespace
}  // namespace tocsin::qos_tool
