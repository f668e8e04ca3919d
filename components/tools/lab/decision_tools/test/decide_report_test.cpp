// SPDX-License-Identifier: Apache-2.0
// Table, JSON, text and picture of the same decisions tell the same.
#include "decide_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/csv_table.hpp"
#include "foundation/temporary_folder.hpp"
#include "traces.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

DecidedTrace decided(unsigned seed, const std::string& policy) {
  return decide_again(random_trace(seed, 300), policy, with_policy(policy));
}

CsvTable table_of(const DecidedTrace& sut) {
  const TemporaryFolder folder;
  return CsvTable::load(folder.write("t.csv", to_csv(sut)));
}

TEST(DecideReport, ItsTableReadsBackAsTheDecisions) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const DecidedTrace sut = decided(seed, "tocp_reverse");
    const CsvTable table = table_of(sut);
    ASSERT_EQ(table.rows(), sut.steps.size());
    for (std::size_t i = 0; i < sut.steps.size(); ++i) {
      const decision::Evidence& one = sut.steps[i].evidence;
      EXPECT_NEAR(table.number(i, "time_s"), sut.steps[i].time_s, 1e-6);
      EXPECT_EQ(table.number(i, "active"), one.state == decision::State::active);
      EXPECT_EQ(table.text(i, "reason"), to_string(one.reason));
      EXPECT_EQ(table.number(i, "age"), one.age);
      EXPECT_EQ(std::isnan(table.number(i, "qni")), std::isnan(one.sample));
      if (std::isfinite(one.statistic)) {
        EXPECT_NEAR(table.number(i, "statistic"), one.statistic, 1e-8 * std::abs(one.statistic));
      }
    }
  }
}

TEST(DecideReport, ItsTableCanBeDecidedAgain) {
  const DecidedTrace first = decided(2, "none");
  const TemporaryFolder folder;
  const QualityTrace again = read_quality_trace(folder.write("t.csv", to_csv(first)), {});
  ASSERT_EQ(again.qni.size(), first.trace.qni.size());
  EXPECT_EQ(again.time_s, first.trace.time_s);
  EXPECT_EQ(again.measured().size(), first.trace.measured().size());
  EXPECT_EQ(again.bad, first.trace.bad);
}

TEST(DecideReport, ItsTableHasTheTruthAlsoWhereAPauseEndedBetweenTwoRows) {
  QualityTrace trace;
  trace.time_s = {0, 1, 1000};
  trace.qni = {80, 20, 80};
  trace.bad = {false, true, false};
  const DecidedTrace sut = decide_again(trace, "", with_policy("threshold"));
  ASSERT_EQ(sut.steps.size(), 4U);
  const TemporaryFolder folder;
  const QualityTrace again = read_quality_trace(folder.write("t.csv", to_csv(sut)), {});
  EXPECT_EQ(again.bad, (std::vector<bool>{false, true, true, false}));
}

TEST(DecideReport, JsonHasEveryRowOrTheChangesOfTheTable) {
  const DecidedTrace sut = decided(4, "tocp");
  const auto rows = to_json(sut, true);
  const auto changes = to_json(sut, false);
  ASSERT_EQ(rows["rows"].size(), sut.steps.size());
  EXPECT_FALSE(rows.contains("changes"));
  std::size_t changed = 0;
  std::string state = "active";
  for (const auto& row : rows["rows"]) {
    if (row["state"] == state) continue;
    state = row["state"];
    ASSERT_LT(changed, changes["changes"].size());
    EXPECT_EQ(changes["changes"][changed++], row);
  }
  EXPECT_EQ(changes["changes"].size(), changed);
  EXPECT_GT(changed, 4U) << "or there is nothing to compare";
  EXPECT_EQ(rows["samples"].get<int>(), 300);
  EXPECT_DOUBLE_EQ(rows["cost"].get<double>(), summarize(sut).cost);
}

TEST(DecideReport, JsonOfWhatWasNotMeasuredIsNull) {
  QualityTrace trace = normal_trace(80, 1, 3);
  trace.qni = {nan, nan, nan};
  const auto sut = to_json(decide_again(trace, "", with_policy("tocp")), true);
  EXPECT_TRUE(sut["rows"][0]["qni"].is_null());
  EXPECT_TRUE(sut["mean_qni_active"].is_null());
  EXPECT_TRUE(sut["mean_qni_passive"].is_null());
  EXPECT_EQ(sut["missing"], 3);
  EXPECT_FALSE(sut.contains("cost")) << "nobody knows the truth";
}

TEST(DecideReport, TextSaysNoneWhereThereIsNoMean) {
  const std::string text = to_text(decide_again(normal_trace(80, 1, 20), "", with_policy("none")));
  EXPECT_THAT(text, HasSubstr(", while passive none\n"));
  EXPECT_THAT(text, HasSubstr("silent 0.0 %"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

/// A controller that was stopped before its first sample leaves rows, but no sample.
TEST(DecideReport, OfARecordingWithoutASampleHasNumbersToo) {
  QualityTrace trace = normal_trace(80, 1, 1);
  trace.qni = {nan};
  trace.recorded = {{true, "steady", 0, true, false, {}}};
  const std::string text = to_text(decide_again(trace, "", with_policy("tocp")));
  EXPECT_THAT(text, HasSubstr("0 samples, 0 without measurement"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(DecideReport, TextNamesCostsAndRegretOfATraceWithTheTruth) {
  const DecidedTrace sut = decide_again(dip(), "", with_policy("none"));
  // spoken in all 40 bad slots; the clairvoyant is silent in 30, speaks in one and is silent again
  const double clairvoyant = 39 * 0.1 + 1 + 4 * 0.5;
  EXPECT_DOUBLE_EQ(summarize(sut).cost, 40);
  EXPECT_NEAR(summarize(sut).oracle_cost, clairvoyant, 1e-9);
  EXPECT_THAT(to_text(sut), HasSubstr("cost 40.0, clairvoyant 6.9, regret 33.1\n"));
}

TEST(DecideReport, PictureHasAPointForEachStep) {
  const DecidedTrace sut = decided(5, "tocp_dsp");
  const auto panels = decide_plot(sut)["panels"];
  ASSERT_EQ(panels.size(), 2U);
  for (const auto& panel : panels) {
    for (const auto& line : panel["lines"]) EXPECT_EQ(line["y"].size(), sut.steps.size());
  }
}

}  // namespace
}  // namespace tocsin::tools
