// SPDX-License-Identifier: Apache-2.0
#include "report/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "report/print.hpp"
#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using ::testing::HasSubstr;

Summary toy_summary() {
  ToyRun run;
  return summarise(load_recording(run.path()));
}

const Traffic& row(const std::vector<Traffic>& rows, const std::string& name) {
  for (const Traffic& traffic : rows) {
    if (traffic.name == name) return traffic;
  }
  throw std::runtime_error("no row " + name);
}

TEST(Summary, AddsUpPausesAndEndsTheLastOneWithTheRun) {
  const Summary sut = toy_summary();
  EXPECT_EQ(sut.pauses, 2);
  EXPECT_EQ(sut.paused_s, 10 + 40);
  EXPECT_EQ(sut.longest_pause_s, 40);
  EXPECT_EQ(sut.length_s, 100);
  EXPECT_EQ(sut.policy, "tocp_dsp");
}

TEST(Summary, DescribesTheNetwork) {
  const Summary sut = toy_summary();
  EXPECT_EQ(sut.qni_min, 30);
  EXPECT_EQ(sut.qni_median, 70);
  EXPECT_EQ(sut.per_percent.p99, 40);
}

TEST(Summary, CountsTrafficOfAClass) {
  const Summary summary = toy_summary();
  const Traffic& sut = row(summary.classes, "uxv low");
  EXPECT_EQ(sut.received, 3U);
  EXPECT_EQ(sut.lost, 2U);
  EXPECT_DOUBLE_EQ(sut.lost_percent(), 40);
  EXPECT_DOUBLE_EQ(sut.latency_s.median, 0.5);
  EXPECT_NEAR(sut.bytes_per_s, 30, 1e-9);
}

// A recording is what peers sent.
TEST(Summary, PrintsNamesPrintableAndNumbersShort) {
  Summary summary = toy_summary();
  summary.mission.name = "m\x1b[2J\n" + std::string(1000, 'a');
  summary.mission.elapsed_s = 1e308;
  summary.classes.front().name = "a\tb";
  summary.classes.front().bytes_per_s = 1e308;
  const std::string text = to_text(summary);
  EXPECT_THAT(text, HasSubstr("Mission   m\\x1b[2J\\na"));
  EXPECT_THAT(text, HasSubstr("a... (1006 bytes): "));
  EXPECT_THAT(text, HasSubstr(" in 1.0e+308 s, "));
  EXPECT_THAT(text, HasSubstr("\na\\tb    "));
  EXPECT_THAT(text, HasSubstr("1e+305\n"));
}

TEST(Summary, AgesATopicUntilTheEndOfTheRun) {
  const Summary summary = toy_summary();
  EXPECT_NEAR(row(summary.classes, "uxv low").age_s.p99, 95, 0.2);
}

TEST(Summary, HasARowForEachTopicAndOneForTheGoals) {
  const Summary sut = toy_summary();
  EXPECT_EQ(row(sut.topics, "uxv camera/image").received, 3U);
  EXPECT_EQ(row(sut.classes, "goals").received, 2U);
  EXPECT_NEAR(row(sut.classes, "goals").latency_s.median, 0.1, 1e-9);
}

TEST(Summary, TellsWhenTheLinkWasPoor) {
  ToyRun run;
  const auto sut = poor_intervals(load_recording(run.path()));
  ASSERT_EQ(sut.size(), 1U);
  EXPECT_EQ(sut[0].begin_s, 1020);
  EXPECT_EQ(sut[0].end_s, 1030);
  EXPECT_EQ(toy_summary().poor_s, 10);
}

TEST(Summary, CountsInPoorIntervalsOnlyWhatWasSentThere) {
  ToyRun run;
  run.append("gcs/messages.csv",
             "1021.25,1021.0,camera/image,1,20,1000\n1029.25,1029.0,camera/image,1,23,1000\n"
             "1030.25,1030.0,camera/image,1,24,1000\n");
  const Summary summary = summarise(load_recording(run.path()));
  const Traffic& sut = row(summary.classes, "uxv low, poor");
  EXPECT_EQ(sut.received, 2U);
  EXPECT_EQ(sut.lost, 2U);
  EXPECT_NEAR(sut.latency_s.median, 0.25, 1e-9);
}

TEST(Summary, WhatWasFilledInIsNotLostAndShownApart) {
  ToyRun run;
  run.append("gcs/messages.csv",
             "1050.0,1002.0,camera/image/backfilled,1,3,1000\n"
             "1050.0,1003.0,camera/image/backfilled,1,4,1000\n");
  const Summary summary = summarise(load_recording(run.path()));
  for (const Traffic& sut :
       {row(summary.classes, "uxv low"), row(summary.topics, "uxv camera/image")}) {
    EXPECT_EQ(sut.received, 3U) << "live";
    EXPECT_EQ(sut.backfilled, 2U);
    EXPECT_EQ(sut.lost, 0U);
    EXPECT_DOUBLE_EQ(sut.latency_s.median, 0.5) << "of what came live";
    EXPECT_NEAR(sut.bytes_per_s, 30, 1e-9);
  }
  EXPECT_THAT(to_text(summary),
              HasSubstr("uxv camera/image                        3           2      0    0.0"));
}

TEST(Summary, WhatWasFilledInIsOfTheIntervalInWhichItWasSent) {
  ToyRun run;
  run.append("gcs/messages.csv",
             "1021.25,1021.0,camera/image,1,20,1000\n1023.25,1023.0,camera/image,1,22,1000\n"
             "1090,1022,camera/image/backfilled,1,21,1000\n"
             "1090,1050,camera/image/backfilled,1,40,1000\n");
  const Summary summary = summarise(load_recording(run.path()));
  const Traffic& sut = row(summary.classes, "uxv low, poor");
  EXPECT_EQ(sut.received, 2U);
  EXPECT_EQ(sut.backfilled, 1U);
  EXPECT_EQ(sut.lost, 0U);
}

TEST(Summary, HasNoLossWithoutTraffic) { EXPECT_TRUE(std::isnan(Traffic{}.lost_percent())); }

TEST(Print, TellsTheMainFacts) {
  const std::string sut = to_text(toy_summary());
  EXPECT_THAT(sut, HasSubstr("mission_a: done, 9 of 9 waypoints in 99.5 s, 12 goals sent"));
  EXPECT_THAT(sut, HasSubstr("tocp_dsp: 2 pauses, 50.0 s of 100.0 s paused, the longest 40.0 s"));
  EXPECT_THAT(
      sut, HasSubstr("uxv low                                 3           0      2   40.0    500"));
}

TEST(Print, SaysWhenNoMissionWasRecorded) {
  EXPECT_THAT(to_text(Summary{}), HasSubstr("Mission   none was recorded"));
}

TEST(Print, ComparesTwoRunsRowByRow) {
  Summary none = toy_summary();
  none.policy = "none";
  none.classes.erase(std::find_if(none.classes.begin(), none.classes.end(),
                                  [](const Traffic& one) { return one.name == "goals"; }));
  const std::string sut = compare_text(none, toy_summary());
  EXPECT_THAT(sut, HasSubstr("| none"));
  EXPECT_THAT(sut, HasSubstr("| tocp_dsp"));
  EXPECT_THAT(sut, HasSubstr("\nuxv low            |    500    500"));
  EXPECT_THAT(sut, HasSubstr("\ngoals              |      -      -      -      -      -  |"));
}

TEST(Print, ColumnsKeepTheirWidthWhateverTheNumbers) {
  Summary summary;
  for (const double value : {0.0, 0.04, 99.94, 99.96, 1234.5, -7.0, 9.9e5, 1e6, 1e300}) {
    Traffic row;
    row.name = "topic";
    row.received = 1;
    row.latency_s = {value / 1000, value / 1000};
    row.age_s = {std::nan(""), value / 1000};
    row.bytes_per_s = value * 1000;
    summary.topics.push_back(row);
  }
  const std::string text = to_text(summary);
  std::istringstream lines(text.substr(text.find("\ntopic") + 1));
  std::size_t width = 0;
  for (std::string line; std::getline(lines, line);) {
    if (width == 0) width = line.size();
    EXPECT_EQ(line.size(), width) << line;
  }
}

}  // namespace
}  // namespace tocsin::report
