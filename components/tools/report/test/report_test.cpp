// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// So that the program is found in the source's folder.
const char* const drawing = "PATH=" TOCSIN_SOURCE_DIR "/src:$PATH";

class ReportTest : public ::testing::Test {
 protected:
  int run(const std::string& arguments, const std::string& environment = "") const {
    const std::string command =
        environment + " " REPORT_PROGRAM " " + arguments + " >" + run_.path("out") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] std::string output() const { return run_.read("out"); }
  ToyRun run_;
};

TEST_F(ReportTest, WritesSummaryAndPlotsOfAMissionWhoseNameIsNoFormula) {
  run_.append("gcs/mission_status.csv", "1101,1101,\"a$\\frac$ `touch made`\",done,8,9,12,99.5\n");
  EXPECT_EQ(run(run_.path(), drawing), 0) << output();
  EXPECT_THAT(output(), StartsWith("Mission   a$"));
  EXPECT_THAT(run_.read("summary.txt"), StartsWith("Mission   a$"));
  EXPECT_THAT(run_.read("plot.png"), StartsWith("\x89PNG"));
  EXPECT_THAT(run_.read("plot.svg"), HasSubstr("<svg"));
}

TEST_F(ReportTest, PrintsTheSummaryWithoutADrawingProgram) {
  EXPECT_EQ(run(run_.path(), "PATH=/nowhere"), 1);
  EXPECT_THAT(output(), StartsWith("Mission   mission_a: done"));
  EXPECT_THAT(output(), HasSubstr("tocsin report: nothing can be drawn: draw_panels is not"));
}

TEST_F(ReportTest, ComparesTwoRuns) {
  EXPECT_EQ(run("--compare " + run_.path() + " " + run_.path()), 0) << output();
  EXPECT_THAT(output(), HasSubstr("latency [ms]"));
}

TEST_F(ReportTest, RejectsAFolderThatIsNoRun) {
  EXPECT_EQ(run("/no/such/run"), 2);
  EXPECT_THAT(output(), StartsWith("tocsin report: /no/such/run/deployment.yaml"));
}

TEST_F(ReportTest, RejectsBadUsage) {
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("--compare " + run_.path()), 2);
  EXPECT_THAT(output(), HasSubstr("--compare needs two run folders"));
  EXPECT_EQ(run(run_.path() + " " + run_.path()), 2);
}

TEST_F(ReportTest, DrawsNothingWhenNoPlotIsWanted) {
  EXPECT_EQ(run("--no-plot " + run_.path(), "PATH=/nowhere"), 0) << output();
  EXPECT_THAT(output(), ::testing::Not(HasSubstr("Plot")));
  EXPECT_EQ(run_.read("plot.svg"), "");
  EXPECT_EQ(run_.read("summary.txt"), output()) << "what it prints is what it writes";
}

TEST_F(ReportTest, ReportsARunWhoseClockWasSet) {
  run_.append("gcs/messages.csv", "1800000000,1800000000,camera/image,1,6,1000\n");
  EXPECT_EQ(run("--no-plot " + run_.path(), "ulimit -v 2000000;"), 0) << output();
  EXPECT_THAT(output(),
              HasSubstr("uxv low                                 4           0      2   33.3"));
}

}  // namespace
}  // namespace tocsin::report
