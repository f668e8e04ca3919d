// SPDX-License-Identifier: Apache-2.0
// The installed program on a slice of the thesis's experiment, and on everything that can go wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "report/csv_table.hpp"
#include "toy.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct Ended {
  int code;
  std::string output;
};

std::string program() {
  const fs::path own = TOCSIN_INSTALL;
  return own / "bin/tocsin-experiment";
}

/// Runs of 40 s of Mission A on the shipped channel.
std::string slice(const std::string& policies, int seeds) {
  const std::string config = std::string(TOCSIN_SOURCE_DIR) + "/../../config/";
  return "duration_s: 40\nwarm_up_s: 5\nobservation_s: 3\nmissions:\n  - {name: a, file: " +
         config + "missions/mission_a.yaml}\nchannels:\n  - {name: thesis, file: " + config +
         "radio/thesis_a.yaml}\npayloads:\n  - {name: plain}\npolicies:\n" + policies +
         "sets:\n  - {name: main, kind: thesis, seeds: " + std::to_string(seeds) + "}\n";
}

const std::string two = "  - {name: none}\n  - {name: tocp_dsp}\n";

class ExperimentTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(program())) GTEST_SKIP() << program() << " is not installed";
  }
  Ended call(const std::string& arguments, const std::string& before = "") {
    const std::string command = before + " timeout 120 " + program() + " " + arguments + " >" +
                                folder_.path("output") + " 2>&1";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), folder_.read("output")};
  }
  Ended run(const std::string& text, const std::string& out, const std::string& before = "") {
    return call(
        "run " + folder_.write("experiment.yaml", text) + " --jobs 2 --out " + folder_.path(out),
        before);
  }
  [[nodiscard]] report::CsvTable table(const std::string& out) const {
    return report::CsvTable::read(folder_.path(out + "/runs.csv"));
  }
  ToyFolder folder_;
};

TEST_F(ExperimentTest, RunsTheComponentsOfTheVehicleAndReports) {
  const Ended sut = run(slice(two, 2), "out");
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, AllOf(HasSubstr("4 of 4 runs"), HasSubstr("times real time")));
  const auto rows = table("out");
  ASSERT_EQ(rows.rows(), 4U);
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(rows.text(row, "failure"), "");
    EXPECT_EQ(rows.number(row, "seconds"), 40);
    EXPECT_GT(rows.number(row, "qni_mean"), 30);
    EXPECT_GT(rows.number(row, "high_delivered"), 50);
  }
  EXPECT_EQ(rows.text(0, "seed"), rows.text(2, "seed"));
  const Ended report = call("report " + folder_.path("out"));
  EXPECT_EQ(report.code, 0) << report.output;
  EXPECT_GT(fs::file_size(folder_.path("out/report.html")), 10000U);
}

TEST_F(ExperimentTest, GivesTheSameBytesAgain) {
  ASSERT_EQ(run(slice(two, 2), "one").code, 0);
  ASSERT_EQ(run(slice(two, 2), "other").code, 0);
  EXPECT_EQ(folder_.read("one/runs.csv"), folder_.read("other/runs.csv"));
  EXPECT_EQ(folder_.read("one/settings.yaml"), folder_.read("other/settings.yaml"));
  int files = 0;
  for (const auto& file : fs::directory_iterator(folder_.path("one/series"))) {
    const std::string name = "series/" + file.path().filename().string();
    EXPECT_EQ(folder_.read("one/" + name), folder_.read("other/" + name)) << name;
    ++files;
  }
  EXPECT_EQ(files, 4);
}

TEST_F(ExperimentTest, GoesOnAfterCtrlC) {
  const std::string file = folder_.write("experiment.yaml", slice(two, 40));
  const std::string out = folder_.path("out");
  const pid_t child = ::fork();
  if (child == 0) {
    (void)!std::freopen(folder_.path("log").c_str(), "w", stdout);
    ::execl(program().c_str(), "tocsin-experiment", "run", file.c_str(), "--jobs", "2", "--out",
            out.c_str(), nullptr);
    ::_exit(127);
  }
  while (!fs::exists(out + "/series") || fs::is_empty(out + "/series")) ::usleep(1000);
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_THAT(folder_.read("log"), HasSubstr("the same command goes on"));
  const std::size_t kept = table("out").rows();
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, 80U);
  const Ended sut = call("run " + file + " --jobs 2 --out " + out);
  EXPECT_EQ(sut.code, 0) << sut.output;
  EXPECT_THAT(sut.output, HasSubstr(std::to_string(kept) + " of 80 runs are there already"));
  EXPECT_EQ(table("out").rows(), 80U);
}

TEST_F(ExperimentTest, NotesAPolicyThatThrowsAndFinishesTheOthers) {
  const Ended sut = run(
      slice(two + "  - {name: broken, policy: tocp, set: [false_alarm_samples=2]}\n", 1), "out");
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output,
              AllOf(HasSubstr("1 runs failed"), HasSubstr("main.a.thesis.plain.broken.1")));
  const auto rows = table("out");
  ASSERT_EQ(rows.rows(), 3U);
  EXPECT_EQ(rows.text(0, "failure"), "");
  EXPECT_NE(rows.text(2, "failure"), "");
}

TEST_F(ExperimentTest, SaysOnceThatTheDiskIsFull) {
  // Files of at most 1 KiB: settings.yaml does not fit.
  const Ended first = run(slice(two, 2), "out", "ulimit -f 1; trap '' XFSZ;");
  EXPECT_EQ(first.code, 1) << first.output;
  EXPECT_THAT(first.output, HasSubstr("cannot be written"));
  // Room for the settings, not for the results.
  ASSERT_EQ(run(slice(two, 1), "size").code, 0);
  const auto blocks = fs::file_size(folder_.path("size/settings.yaml")) / 1024 + 1;
  ASSERT_LT(fs::file_size(folder_.path("size/runs.csv")), blocks * 1024);
}

TEST_F(ExperimentTest, RefusesWhatIsWrongBeforeTheFirstRun) {
  const Ended key = run(slice("  - {name: tocp, set: [alfa=3]}\n", 1), "out");
  EXPECT_EQ(key.code, 2);
  EXPECT_THAT(key.output, AllOf(HasSubstr("alfa"), HasSubstr("tocp")));
  const Ended range = run(slice("  - {name: tocp, set: [alpha=-3]}\n", 1), "out");
  EXPECT_EQ(range.code, 2);
  EXPECT_THAT(range.output, HasSubstr("alpha: -3 is outside"));
  const Ended policy = run(slice("  - {name: luck}\n", 1), "out");
  EXPECT_EQ(policy.code, 2);
  EXPECT_THAT(policy.output, HasSubstr("luck"));
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(ExperimentTest, DoesNotMixTwoExperiments) {
  ASSERT_EQ(run(slice(two, 1), "out").code, 0);
  const Ended sut = run(slice(two, 2), "out");
  EXPECT_EQ(sut.code, 2);
  EXPECT_THAT(sut.output, HasSubstr("other settings"));
}

TEST_F(ExperimentTest, RefusesABadCommandLine) {
  EXPECT_EQ(call("run").code, 2);
  EXPECT_EQ(call("run /nonexistent.yaml").code, 2);
  EXPECT_EQ(call("report /tmp").code, 2);
  EXPECT_EQ(call("dance").code, 2);
}

}  // namespace
}  // namespace tocsin::experiment
