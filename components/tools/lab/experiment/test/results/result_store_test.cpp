// SPDX-License-Identifier: Apache-2.0
#include "results/result_store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <system_error>

#include "metrics/toy_recording.hpp"
#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

RunResult good() { return {"", 100, measure(toy_recording(), toy_timing())}; }

/// Every file of this process is at most one byte long, as on a full disk.
class FullDisk {
 public:
  FullDisk() {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit tiny{1, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tiny);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(ResultText, OfAFailedRunIsOneLineOfReason) {
  const auto sut = parse_result(to_text({"policy: threw\nbadly", 0, {}}));
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->failure, "policy: threw badly");
  EXPECT_TRUE(sut->measures.series.empty());
}

TEST(ResultText, ThatWasCutOffAnywhereIsNoResult) {
  const std::string text = to_text(good());
  for (std::size_t length = 0; length + 1 < text.size(); length += 7) {
    EXPECT_FALSE(parse_result(text.substr(0, length))) << length;
  }
}

TEST(ResultStore, KeepsRunsAndTellsThemInTheOrderOfThePlan) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  const ResultStore sut(toy.path("out"), "series");
  sut.open("settings: 1\n");
  sut.write(plan[3], good());
  sut.write(plan[1], {"went, \"wrong\"", 0, {}});
  sut.write_table(plan);
  const std::string table = toy.read("out/runs.csv");
  EXPECT_THAT(table, StartsWith("number,set,mission,"));
  EXPECT_LT(table.find("\n1,main,a,near,camera,none,2,"), table.find("\n3,main,a,near,camera,"));
  EXPECT_THAT(table, HasSubstr(",\"went, \"\"wrong\"\"\",0,"));
}

TEST(ResultStore, GivesTheSameBytesWhateverFinishedFirst) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  const ResultStore one(toy.path("one"), "series");
  const ResultStore other(toy.path("other"), "series");
  one.open("s");
  other.open("s");
  for (const int i : {0, 1, 2}) one.write(plan[static_cast<std::size_t>(i)], good());
  for (const int i : {2, 0, 1}) other.write(plan[static_cast<std::size_t>(i)], good());
  one.write_table(plan);
  other.write_table(plan);
  EXPECT_EQ(toy.read("one/runs.csv"), toy.read("other/runs.csv"));
}

TEST(ResultStore, GoesOnWithTheSameSettingsOnly) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  const ResultStore sut(toy.path("out"), "series");
  sut.open("settings: 1\n");
  sut.write(plan[0], good());
  EXPECT_NO_THROW(sut.open("settings: 1\n"));
  EXPECT_TRUE(sut.read(plan[0]));
  EXPECT_FALSE(sut.read(plan[1]));
  EXPECT_THAT(error_of([&] { sut.open("settings: 2\n"); }), HasSubstr("other settings"));
}

TEST(ResultStore, GoesOnWithAnotherBuildOnlyWhenTold) {
  const TemporaryFolder folder;
  const ResultStore sut(folder.path("out"), "series");
  sut.open("build: one\nseeds: 3\n");
  EXPECT_THAT(error_of([&] { sut.open("build: two\nseeds: 3\n"); }), HasSubstr("--other-build"));
  EXPECT_EQ(folder.read("out/settings.yaml"), "build: one\nseeds: 3\n");
  sut.open("build: two\nseeds: 3\n", true);
  EXPECT_EQ(folder.read("out/settings.yaml"), "build: two\nearlier_builds: [one]\nseeds: 3\n");
  EXPECT_NO_THROW(sut.open("build: two\nseeds: 3\n"));
  EXPECT_THAT(error_of([&] { sut.open("build: two\nseeds: 4\n", true); }),
              HasSubstr("other settings"));
  sut.open("build: three\nseeds: 3\n", true);
  EXPECT_EQ(folder.read("out/settings.yaml"),
            "build: three\nearlier_builds: [two, one]\nseeds: 3\n");
}

TEST(ResultStore, RemovesDraftsOfKilledRuns) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  const ResultStore sut(toy.path("out"), "series");
  sut.open("s");
  toy.write("out/series/x.csv.new", "half");
  sut.open("s");
  EXPECT_FALSE(std::filesystem::exists(toy.path("out/series/x.csv.new")));
}

TEST(ResultStore, DoesNotTakeADamagedFileForAResult) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  const ResultStore sut(toy.path("out"), "series");
  sut.open("s");
  toy.write("out/series/" + plan[0].id() + ".csv", "failure \nseconds 3\n");
  EXPECT_FALSE(sut.read(plan[0]));
}

TEST(ResultStore, SaysThatAFolderCannotBeMade) {
  EXPECT_THROW(ResultStore("/proc/nowhere", "series").open("s"), EnvironmentError);
}

TEST(WriteWhole, LeavesTheOldOneWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string path = folder.path("file");
  write_whole(path, "old");
  {
    const FullDisk full;
    EXPECT_THROW(write_whole(path, "new text"), std::system_error);
  }
  EXPECT_EQ(folder.read("file"), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST(ResultText, HasSixDigitsAndNothingForNothing) {
  RunResult result;
  result.simulated_s = 1234567.8;
  result.measures.values = {1.0 / 3, std::nan(""), -0.0};
  const std::string sut = to_text(result);
  EXPECT_THAT(sut, HasSubstr("seconds 1.23457e+06\n"));
  EXPECT_THAT(sut, HasSubstr("values 0.333333,,0\n"));
}

TEST(ResultText, KeepsEveryPartOfAnObservation) {
  RunResult result;
  result.measures.values = {1, std::nan("")};
  result.measures.series = {
      {6, 71, 5, 12, 0.5, 0.25, 30, 3, 20, true},
      {12, std::nan(""), std::nan(""), std::nan(""), 1, 0, 0, 0, std::nan(""), false}};
  const auto sut = parse_result(to_text(result));
  ASSERT_TRUE(sut);
  const Observation& one = sut->measures.series[0];
  EXPECT_TRUE(std::isnan(sut->measures.values[1]));
  EXPECT_EQ(one.time_s, 6);
  EXPECT_EQ(one.qni, 71);
  EXPECT_EQ(one.probe_per, 5);
  EXPECT_EQ(one.snr_db, 12);
  EXPECT_EQ(one.active, 0.5);
  EXPECT_EQ(one.poor, 0.25);
  EXPECT_EQ(one.sent, 30);
  EXPECT_EQ(one.lost, 3);
  EXPECT_EQ(one.latency_ms, 20);
  EXPECT_TRUE(one.stalled);
  EXPECT_TRUE(std::isnan(sut->measures.series[1].qni));
  EXPECT_TRUE(std::isnan(sut->measures.series[1].latency_ms));
  EXPECT_FALSE(sut->measures.series[1].stalled);
}

TEST(ResultText, OfFewerMetricsHasNoAnswerForTheNewOnes) {
  const auto sut = parse_result(
      "failure \nseconds 3\nvalues 1,2\n"
      "time_s,qni,probe_per,snr_db,active,poor,sent,lost,latency_ms,stalled\nend\n");
  ASSERT_TRUE(sut);
  EXPECT_EQ(sut->measures.values.size(), metric_count);
  EXPECT_EQ(sut->measures.values[1], 2);
  EXPECT_TRUE(std::isnan(sut->measures.values[2]));
}

TEST(ResultText, WithAnotherHeadIsNoResult) {
  EXPECT_FALSE(parse_result("failure \nseconds 3\nvalues 1\ntime_s,qni\nend\n"));
  EXPECT_FALSE(parse_result(""));
  EXPECT_FALSE(parse_result("seconds 3\n"));
}

TEST(ResultText, OfAShortRowIsNoResult) {
  std::string text = to_text(good());
  const std::size_t row = text.find("\n10,");
  text.erase(row + 1, 3);
  EXPECT_FALSE(parse_result(text));
}

TEST(ResultStore, KeepsEachKindInAFolderAndATableOfItsOwn) {
  const ToyExperiment toy;
  const auto plan = make_plan(toy.load());
  for (const char* kind : {"series", "real", "fit"}) {
    const ResultStore sut(toy.path("out"), kind);
    sut.open("s");
    sut.write(plan[0], good());
    sut.write_table(plan);
    EXPECT_TRUE(std::filesystem::exists(
        toy.path("out/" + std::string(kind) + "/" + plan[0].id() + ".csv")));
  }
  for (const char* table : {"runs.csv", "real.csv", "fit.csv"}) {
    EXPECT_TRUE(std::filesystem::exists(toy.path("out/" + std::string(table)))) << table;
  }
}

}  // namespace
}  // namespace tocsin::experiment
