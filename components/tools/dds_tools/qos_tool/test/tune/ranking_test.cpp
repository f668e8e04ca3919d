// SPDX-License-Identifier: Apache-2.0
#include "tune/ranking.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tocsin::qos_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<Candidate> candidates{{"shipped", {}},
                                        {"c1", {{"qos.stream.lifespan_s", "0.5"}}},
                                        {"c2", {{"qos.stream.lifespan_s", "4"}}}};

/// A row of runs.csv.
std::string row(const char* policy, int index, const std::string& cost,
                const std::string& failure = "") {
  return std::string("b,thesis,camera,") + policy + "," + std::to_string(index) + "," + failure +
         "," + cost + ",1,2,95,0.3,150\n";
}

std::vector<RankedCandidate> ranking(const std::string& rows) {
  const std::string text =
      "mission,channel,payload,policy,index,failure,user_cost,critical_late,high_late,"
      "low_delivered,location_age_p99,picture_latency_p99\n" +
      rows;
  return rank(CsvTable(text), candidates);
}

TEST(MeanInterval, IsStudentsOverTheRuns) {
  // Mean 3, standard deviation 1.581, error 0.7071; t(4, 97.5 %) = 2.776.
  const MeanInterval sut = mean_interval({1, 2, 3, 4, 5});
  EXPECT_DOUBLE_EQ(sut.mean, 3);
  EXPECT_NEAR(sut.low, 3 - 2.776 * 0.7071, 1e-3);
  EXPECT_NEAR(sut.high, 3 + 2.776 * 0.7071, 1e-3);
  EXPECT_TRUE(std::isnan(mean_interval({1}).low));
}

TEST(MeanInterval, IsWiderWhenManyAreToHoldTogether) {
  // Two comparisons: t(4, 98.75 %) = 3.495.
  EXPECT_NEAR(mean_interval({1, 2, 3, 4, 5}, 2).high, 3 + 3.495 * 0.7071, 1e-3);
}

TEST(Rank, PairsRunsThatMetTheSameRadio) {
  const auto sut =
      ranking(row("shipped", 1, "10") + row("shipped", 2, "30") + row("shipped", 3, "20") +
              row("c1", 3, "17.5") + row("c1", 1, "8") + row("c1", 2, "28.5") + row("c2", 1, "11") +
              row("c2", 2, "31.5") + row("c2", 3, "20.5"));
  ASSERT_EQ(sut.size(), 3U);
  EXPECT_EQ(sut[0].candidate.name, "c1");
  EXPECT_DOUBLE_EQ(sut[0].difference.mean, -2);
  EXPECT_LT(sut[0].difference.high, 0) << "though runs differ by 20";
  EXPECT_DOUBLE_EQ(sut[0].cost, 18);
  EXPECT_EQ(sut[1].candidate.name, "shipped");
  EXPECT_EQ(sut[2].candidate.name, "c2");
  const std::string text = ranking_text(sut);
  EXPECT_THAT(text, HasSubstr("Costs least, and less than what is shipped by 2.00"));
  EXPECT_THAT(text, HasSubstr("qos.stream.lifespan_s=0.5 (better)"));
  EXPECT_THAT(text, HasSubstr("c2"));
}

TEST(Rank, ARunThatFailedCountsForNobody) {
  const auto sut = ranking(row("shipped", 1, "10") + row("shipped", 2, "", "crashed") +
                           row("c1", 1, "9") + row("c1", 2, "1"));
  ASSERT_EQ(sut.size(), 2U);
  EXPECT_EQ(sut[0].runs, 1U);
  EXPECT_DOUBLE_EQ(sut[0].cost, 9);
}

/// c1 costs as much as what is shipped but for `noise` up and down, over ten runs.
std::string conclusion_with(double noise) {
  std::string rows;
  for (int index = 1; index <= 10; ++index) {
    rows += row("shipped", index, "100");
    rows += row("c1", index, std::to_string(100 + (index % 2 == 0 ? noise : -noise)));
  }
  const std::string text = ranking_text(ranking(rows));
  return text.substr(text.rfind("No candidate"));
}

TEST(Rank, TheShippedOnesStandConfirmedWhenTheRunsLeaveNoGainOpen) {
  // Two comparisons: half an interval is 0.89 times the noise; a gain of 5 of 100 is worth it.
  EXPECT_THAT(conclusion_with(5.5), HasSubstr("of 100.00: it stands confirmed"));
}

TEST(Rank, WideIntervalsConfirmNothing) {
  const std::string text = conclusion_with(5.7);
  EXPECT_THAT(text, HasSubstr("the runs leave open whether c1 costs up to 5.1"));
  EXPECT_THAT(text, HasSubstr("add seeds"));
  EXPECT_THAT(conclusion_with(5000), Not(HasSubstr("confirmed")));
}

}  // namespace
}  // namespace tocsin::qos_tool
