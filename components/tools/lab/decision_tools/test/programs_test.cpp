// SPDX-License-Identifier: Apache-2.0
// The three programs as a user runs them: exit codes, one line of error, files that they write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "foundation/temporary_folder.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

class Programs : public ::testing::Test {
 protected:
  Programs() {
    std::string good = "qni\n";
    std::string bad = "qni\n";
    std::string trace = "time_s,qni\n";
    for (int i = 0; i < 200; ++i) {
      const double wave = std::sin(i * 1.7) + std::sin(i * 0.61);
      good += std::to_string(82 + 7 * wave) + "\n";
      bad += std::to_string(36 + 6 * wave) + "\n";
      trace += std::to_string(i) + "," + std::to_string(i % 80 < 60 ? 82 + 7 * wave : 36) + "\n";
    }
    folder.write("good.csv", good);
    folder.write("bad.csv", bad);
    folder.write("trace.csv", trace);
  }
  int run(const std::string& command) {
    const int status =
        std::system(("cd " + folder.path("") + " && " + command + " >out.txt 2>err.txt").c_str());
    output = folder.read("out.txt");
    error = folder.read("err.txt");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// Exit code 2 and exactly one line that holds `text`.
  void expect_error(const std::string& command, const std::string& text) {
    EXPECT_EQ(run(command), 2) << command;
    EXPECT_THAT(error, HasSubstr(text));
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
  }
  TemporaryFolder folder;
  std::string output;
  std::string error;
};

TEST_F(Programs, FitDecideAndDesignWorkTogether) {
  ASSERT_EQ(run(FIT_PROGRAM " good.csv bad.csv --family normal --model m.yaml"), 0) << error;
  EXPECT_THAT(folder.read("m.yaml"), HasSubstr("good_mean: 8"));
  ASSERT_EQ(run(DECIDE_PROGRAM " trace.csv --policy tocp_dsp --model m.yaml --table t.csv"), 0);
  EXPECT_THAT(output, HasSubstr("2 pauses"));
  EXPECT_THAT(folder.read("t.csv"), HasSubstr("cusum_alarm"));
  ASSERT_EQ(run(DESIGN_PROGRAM " --false-alarm 1h --model m.yaml --recording good.csv "
                               "--period 1 --set bad_mean=60"),
            0)
      << error;
  EXPECT_THAT(output, HasSubstr("calibrated on good.csv"));
}

TEST_F(Programs, PrintJson) {
  ASSERT_EQ(run(FIT_PROGRAM " good.csv bad.csv --json"), 0);
  EXPECT_EQ(nlohmann::json::parse(output)["good"]["samples"], 200);
  ASSERT_EQ(run(DECIDE_PROGRAM " trace.csv --policy tocp --json --rows"), 0);
  EXPECT_EQ(nlohmann::json::parse(output)["rows"].size(), 200U);
  ASSERT_EQ(run(DESIGN_PROGRAM " --false-alarm 2h --json"), 0);
  EXPECT_EQ(nlohmann::json::parse(output)["false_alarm_s"], 7200);
}

TEST_F(Programs, DrawPngAndSvg) {
  const std::string path = "env PATH=" TOCSIN_REPOSITORY "/components/tools/report/src:$PATH ";
  ASSERT_EQ(run(path + FIT_PROGRAM " good.csv bad.csv --plot fit"), 0) << error;
  ASSERT_EQ(run(path + DECIDE_PROGRAM " trace.csv --policy tocp --plot decisions"), 0) << error;
  for (const char* name : {"fit", "decisions"}) {
    EXPECT_EQ(folder.read(std::string(name) + ".png").substr(1, 3), "PNG");
    EXPECT_THAT(folder.read(std::string(name) + ".svg"), HasSubstr("</svg>"));
  }
}

TEST_F(Programs, SayInOneLineWhenNothingCanBeDrawn) {
  EXPECT_EQ(run("env PATH=/nonexistent " FIT_PROGRAM " good.csv bad.csv --plot fit"), 1);
  EXPECT_THAT(error, HasSubstr("nothing can be drawn: draw_panels is not installed"));
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
}

TEST_F(Programs, HaveOneLineForEveryBadInput) {
  folder.write("empty.csv", "");
  folder.write("text.csv", "qni\n50\nbad\n");
  folder.write("column.csv", "a,b\n1,2\n");
  folder.write("one.csv", "qni\n50\n");
  std::string constant = "qni\n";
  for (int i = 0; i < 30; ++i) constant += "50\n";
  folder.write("constant.csv", constant);
  folder.write("back.csv", "t,qni\n2,50\n1,50\n");
  folder.write("roles.csv", "receive_s,role,qni\n1,uxv,50\n1,gcs,60\n");
  folder.write("contrary.yaml", "policy: tocp\npause_below_qni: 60\n");
  const std::string fit = FIT_PROGRAM;
  expect_error(fit + " empty.csv bad.csv", "empty.csv: is empty");
  expect_error(fit + " text.csv bad.csv", "text.csv:3: qni: 'bad' is not a number");
  expect_error(fit + " column.csv bad.csv", "column.csv: has no column qni");
  expect_error(fit + " one.csv bad.csv", "one.csv: 1 samples, at least 10");
  expect_error(fit + " constant.csv bad.csv", "constant.csv: all 30 samples equal 50");
  expect_error(fit + " bad.csv good.csv",
               "bad.csv (good), good.csv (bad): model: mean of the good law");
  expect_error(fit + " none.csv bad.csv", "none.csv: cannot be read");
  expect_error(fit + " good.csv", "BAD is required");
  expect_error(DECIDE_PROGRAM " trace.csv --policy magic", "'magic' is not one of");
  expect_error(DECIDE_PROGRAM " trace.csv", "trace.csv: is of no run, so that --policy must name");
  expect_error(DECIDE_PROGRAM " trace.csv --policy oracle", "needs the truth");
  expect_error(DECIDE_PROGRAM " trace.csv --set alpha=-1", "policy.alpha: -1 is outside");
  expect_error(DECIDE_PROGRAM " back.csv", "back.csv:3: t: 1 is 1.000 s before the row above");
  expect_error(DECIDE_PROGRAM " roles.csv", "roles.csv: has decisions of the roles uxv and gcs");
  expect_error(DECIDE_PROGRAM " trace.csv --model contrary.yaml",
               "contrary.yaml: policy.pause_below_qni: 60 must be at most resume_at_qni, 50");
  expect_error(DESIGN_PROGRAM " --false-alarm 1min", "cannot be had with these laws");
  expect_error(DESIGN_PROGRAM " --false-alarm soon", "'soon' is not a duration");
}

TEST_F(Programs, FitRefusesARecordingWithHardlyAnySpreadAndLeavesTheOldModel) {
  std::string still = "qni\n";
  for (int i = 0; i < 20; ++i) still += i % 2 == 0 ? "90.001\n" : "90.002\n";
  folder.write("still.csv", still);
  folder.write("m.yaml", "alpha: 3\n");
  expect_error(FIT_PROGRAM " still.csv bad.csv --family normal --model m.yaml",
               "still.csv (good), bad.csv (bad): policy.good_sd: 0.0005 is outside");
  EXPECT_EQ(folder.read("m.yaml"), "alpha: 3\n");
}

TEST_F(Programs, DecidePrintsItsTableOrItsJson) {
  const std::string decide = DECIDE_PROGRAM " trace.csv --policy tocp";
  ASSERT_EQ(run(decide + " --table -"), 0) << error;
  EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 201);
  EXPECT_THAT(output, ::testing::StartsWith("time_s,qni,active,reason,"));
  expect_error(decide + " --table - --json", "--table -: prints the table in place of the JSON");
  expect_error(decide + " --rows", "--rows requires --json");
  expect_error(decide + " --table no/t.csv", "no/t.csv: cannot be written: No such file");
  expect_error(decide + " --table /dev/full", "No space left on device");
  expect_error(decide + " --plot no/p", "--plot: folder no does not exist");
}

TEST_F(Programs, DecideTakesTheColumnTheStepAndTheTruthOfAForeignFile) {
  std::string foreign = "quality,state\n";
  for (int i = 0; i < 60; ++i) foreign += i < 20 ? "90,0\n" : "20,1\n";
  folder.write("foreign.csv", foreign);
  const std::string decide = DECIDE_PROGRAM " foreign.csv --column quality --period 6 --json ";
  ASSERT_EQ(run(decide + "--policy oracle"), 0) << error;
  const auto oracle = nlohmann::json::parse(output);
  EXPECT_EQ(oracle["cost"], oracle["oracle_cost"]);
  ASSERT_EQ(run(decide + "--policy threshold --rows"), 0) << error;
  const auto threshold = nlohmann::json::parse(output);
  EXPECT_EQ(threshold["oracle_cost"], oracle["cost"]);
  EXPECT_GT(threshold["cost"], oracle["cost"]);
  EXPECT_EQ(threshold["rows"][1]["time_s"], 6);
}

TEST_F(Programs, DesignRefusesBlocksAndSeedsThatAreNone) {
  const std::string design =
      DESIGN_PROGRAM " --false-alarm 5min --period 1 --set bad_mean=60 --recording good.csv";
  expect_error(design + " --block 0.2", "--block: 0.2 s must be at least one sample, 1 s");
  expect_error(design + " --block 0", "--block");
  expect_error(design + " --seed -1", "--seed");
}

TEST_F(Programs, ExplainThemselves) {
  for (const char* program : {FIT_PROGRAM, DECIDE_PROGRAM, DESIGN_PROGRAM}) {
    EXPECT_EQ(run(std::string(program) + " --help"), 0);
    EXPECT_THAT(output, HasSubstr("--json"));
  }
}

TEST_F(Programs, ReadMeasuredWifi) {
  const char* shared = std::getenv("TOCSIN_SHARED");
  const std::string root = shared ? shared : TOCSIN_REPOSITORY "/../shared";
  const std::string traces = root + "/data/traces";
  if (!std::filesystem::exists(traces)) GTEST_SKIP() << "no measured traces on this machine";
  for (const auto& file : std::filesystem::directory_iterator(traces)) {
    EXPECT_EQ(run(DECIDE_PROGRAM " " + file.path().string() + " --policy tocp_reverse"), 0)
        << error;
    EXPECT_THAT(output, HasSubstr("measured Wi-Fi"));
  }
}

}  // namespace
}  // namespace tocsin::tools
